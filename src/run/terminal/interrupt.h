#pragma once

namespace fumon {

/// While one exists, SIGINT and SIGTERM only set a flag (a second one ends the program at once),
/// and SIGPIPE is ignored, so that a closed pipe is an ordinary write error.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// The signal that asked the program to stop, or 0.
int interrupting_signal();

/// The exit status of a program that this signal stopped: 128 + signal, as shells have it.
int exit_status_of_signal(int signal);

/// Forgets it (for tests that run several commands in one process).
void clear_interrupt();

}  // namespace fumon
