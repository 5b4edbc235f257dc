#pragma once

namespace fumon {

/// While one exists, SIGINT and SIGTERM only ask the program to stop (a second one ends it at once;
/// base/cancellation.h says how long work may go on), and SIGPIPE is ignored, so that a closed pipe
/// is an ordinary write error. What was done at SIGINT and SIGTERM before is done again after it.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

  private:
    using Handler = void (*)(int);
    Handler before_interrupt_;
    Handler before_termination_;
};

/// While one exists, a first signal already ends the program at once, with the status of a stopped
/// program: for the time in which it prepares its work, which may last, and has written nothing.
class ExitOnSignal {
  public:
    ExitOnSignal();
    ~ExitOnSignal();
    ExitOnSignal(const ExitOnSignal&) = delete;
    ExitOnSignal& operator=(const ExitOnSignal&) = delete;
};

/// Asks the program to stop, as this signal would (for those who handle signals themselves).
void request_stop(int signal);

/// The signal that asked the program to stop, or 0.
int interrupting_signal();

/// The exit status of a program that this signal stopped: 128 + signal, as shells have it.
int exit_status_of_signal(int signal);

/// Forgets it (for tests that run several commands in one process).
void clear_interrupt();

}  // namespace fumon
