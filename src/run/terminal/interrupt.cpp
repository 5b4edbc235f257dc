#include "run/terminal/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "base/cancellation.h"

namespace fumon {

namespace {

std::atomic<int> received{0};
std::atomic<int> exiting_on_signal{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

void note_signal(int signal) {
    if (exiting_on_signal.load() != 0) _exit(exit_status_of_signal(signal));
    stop_requested_at_ns.store(monotonic_nanoseconds());
    if (received.exchange(signal) != 0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

InterruptGuard::InterruptGuard()
    : before_interrupt_(std::signal(SIGINT, note_signal)),
      before_termination_(std::signal(SIGTERM, note_signal)) {
    std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, before_interrupt_);
    std::signal(SIGTERM, before_termination_);
}

ExitOnSignal::ExitOnSignal() {
    ++exiting_on_signal;
}

ExitOnSignal::~ExitOnSignal() {
    --exiting_on_signal;
}

void request_stop(int signal) {
    stop_requested_at_ns.store(monotonic_nanoseconds());
    received.store(signal);
}

int interrupting_signal() {
    return received.load();
}

int exit_status_of_signal(int signal) {
    constexpr int signal_status_offset = 128;
    return signal_status_offset + signal;
}

void clear_interrupt() {
    received.store(0);
    stop_requested_at_ns.store(0);
}

}  // namespace fumon
