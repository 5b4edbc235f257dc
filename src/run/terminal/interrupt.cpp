#include "run/terminal/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "base/give_up.h"

namespace fumon {

namespace {

std::atomic<int> received{0};
std::atomic<int> ending_at_once{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

void note_signal(int signal) {
    if (ending_at_once.load() != 0) _exit(exit_status_of_signal(signal));
    asked_to_stop_at.store(monotonic_nanoseconds());
    if (received.exchange(signal) != 0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

InterruptGuard::InterruptGuard() {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
    std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

EndAtOnce::EndAtOnce() {
    ++ending_at_once;
}

EndAtOnce::~EndAtOnce() {
    --ending_at_once;
}

void request_stop(int signal) {
    asked_to_stop_at.store(monotonic_nanoseconds());
    received.store(signal);
}

int interrupting_signal() {
    return received.load();
}

int exit_status_of_signal(int signal) {
    constexpr int beyond_every_own_status = 128;
    return beyond_every_own_status + signal;
}

void clear_interrupt() {
    received.store(0);
    asked_to_stop_at.store(0);
}

}  // namespace fumon
