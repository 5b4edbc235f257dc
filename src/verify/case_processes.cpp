#include "verify/case_processes.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "base/cancellation.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "run/terminal/interrupt.h"

namespace fumon {

namespace {

constexpr int poll_milliseconds = 100;

/// Writes all, or ends this process: its parent is gone.
void write_all(int descriptor, const void* data, std::size_t count) {
    const auto* bytes = static_cast<const char*>(data);
    while (count > 0) {
        const ssize_t written = ::write(descriptor, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) ::_exit(could_not_work);
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

/// "crashed (Segmentation fault)", for a status of waitpid().
std::string termination_text(int status) {
    if (WIFEXITED(status)) {
        return fmt::format(
            "the process that drew it ended with status {} before it was done; standard error may "
            "say why",
            WEXITSTATUS(status));
    }
    const int signal = WTERMSIG(status);
    const char* name = ::strsignal(signal);  // NOLINT(concurrency-mt-unsafe): one thread
    const char* hint = signal == SIGKILL ? "; the system kills so what takes too much memory" : "";
    return fmt::format("the process that drew it crashed: signal {} ({}){}", signal,
                       name == nullptr ? "unknown" : name, hint);
}

}  // namespace

CaseProcesses::CaseProcesses(std::size_t count, Work work)
    : count_(count), work_(std::move(work)) {}

CaseProcesses::~CaseProcesses() {
    if (child_ > 0) {
        ::kill(child_, SIGKILL);
        wait_for_child();
    }
}

CaseResult CaseProcesses::next() {
    if (const int signal = interrupting_signal(); signal != 0) return stop(signal);
    const Stopwatch watch;
    if (child_ < 0) start();
    std::vector<std::uint8_t> message;
    const Answer answer = receive(message);
    if (answer == Answer::stopped) return stop(interrupting_signal());
    ++next_;
    if (answer == Answer::ended) {
        CaseResult result = child_termination();
        result.seconds = watch.seconds();
        return result;
    }
    CaseResult result = result_of(message);
    if (result.signal != 0) {
        // It was asked to stop, as this process should be at any moment if a terminal or a service
        // asked both.
        ::poll(nullptr, 0, poll_milliseconds);
        if (const int signal = interrupting_signal(); signal != 0) return stop(signal);
        wait_for_child();
        return undrawn(
            Outcome::failed,
            fmt::format("the process that drew it was ended by signal {}", result.signal));
    }
    if (result.needs_new_process) wait_for_child();
    return result;
}

void CaseProcesses::start() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        throw Error(fmt::format("cannot make a pipe: {}", std::generic_category().message(errno)));
    std::fflush(nullptr);  // what is not written yet would be written twice
    const pid_t parent = ::getpid();
    child_ = ::fork();
    if (child_ < 0) {
        const int reason = errno;
        ::close(ends[0]);
        ::close(ends[1]);
        throw Error(fmt::format("cannot start a process: {}; --no-isolate draws without one",
                                std::generic_category().message(reason)));
    }
    if (child_ == 0) {
        ::close(ends[0]);
#ifdef __linux__
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        if (::getppid() != parent) ::_exit(could_not_work);
        run_child(ends[1]);
    }
    ::close(ends[1]);
    from_child_ = ends[0];
}

void CaseProcesses::run_child(int to_parent) const {
    std::signal(SIGINT, SIG_IGN);  // of a terminal, which sends it to both: the parent passes it on
    try {
        send_results(to_parent);
    } catch (...) {
        ::_exit(could_not_work);  // and never into what the parent does about an exception
    }
    // Nothing is left to do, and what the parent has open is not this process's to end.
    ::_exit(all_is_well);
}

void CaseProcesses::send_results(int to_parent) const {
    for (std::size_t number = next_; number < count_; ++number) {
        const CaseResult result = work_(number);
        const std::vector<std::uint8_t> message = message_of(result);
        const std::uint64_t size = message.size();
        write_all(to_parent, &size, sizeof size);
        write_all(to_parent, message.data(), message.size());
        if (result.signal != 0 || result.needs_new_process) return;
    }
}

CaseProcesses::Answer CaseProcesses::receive(std::vector<std::uint8_t>& message) {
    std::uint64_t size = 0;
    const Answer head = receive(reinterpret_cast<std::uint8_t*>(&size), sizeof size);
    if (head != Answer::came) return head;
    message.resize(size);
    return receive(message.data(), message.size());
}

CaseProcesses::Answer CaseProcesses::receive(std::uint8_t* to, std::size_t count) {
    while (count > 0) {
        if (interrupting_signal() != 0) return Answer::stopped;
        pollfd waited{from_child_, POLLIN, 0};
        if (::poll(&waited, 1, poll_milliseconds) <= 0) continue;
        const ssize_t got = ::read(from_child_, to, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return Answer::ended;
        to += got;
        count -= static_cast<std::size_t>(got);
    }
    return Answer::came;
}

CaseResult CaseProcesses::child_termination() {
    return undrawn(Outcome::failed, termination_text(wait_for_child()));
}

CaseResult CaseProcesses::stop(int signal) {
    if (child_ > 0) {
        ::kill(child_, SIGTERM);
        const Stopwatch watch;
        std::array<std::uint8_t, 4096> ignored{};
        // A child that is at its work ends it within `cancellation_grace_s`; one in a driver may
        // not.
        while (watch.seconds() < 2.0 * cancellation_grace_s) {
            pollfd waited{from_child_, POLLIN, 0};
            if (::poll(&waited, 1, poll_milliseconds) <= 0) continue;
            if (::read(from_child_, ignored.data(), ignored.size()) == 0) break;
        }
        ::kill(child_, SIGKILL);
        wait_for_child();
    }
    CaseResult result = undrawn(Outcome::failed, "stopped");
    result.signal = signal;
    return result;
}

int CaseProcesses::wait_for_child() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
    ::close(from_child_);
    child_ = -1;
    from_child_ = -1;
    return status;
}

}  // namespace fumon
