#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "verify/case_result.h"

namespace fumon {

/// Does the work of cases, one after another, in a child process, so that a crash in a driver or a
/// library is the fault of one case. The child goes on from case to case, which costs one fork for
/// all of them; where it ends before its time, the case that it was at has failed, and a new child
/// goes on with the next.
///
/// The child is forked and not a program of its own: it then has all that was read and asked. That
/// is sound because the parent never draws, runs no model and starts no thread, so that no lock of
/// OSMesa or of a pool can be held at a fork, and sanitizers allow it. Results come through a pipe,
/// since the parent alone writes files.
class CaseProcesses {
  public:
    /// What is done of case number 0 … count - 1. In the child.
    using Work = std::function<CaseResult(std::size_t)>;

    CaseProcesses(std::size_t count, Work work);
    ~CaseProcesses();  ///< ends the child
    CaseProcesses(const CaseProcesses&) = delete;
    CaseProcesses& operator=(const CaseProcesses&) = delete;

    /// The result of the next case. It has a signal where one asked this process to stop; the child
    /// has ended then. Throws Error where no process can be started.
    CaseResult next();

  private:
    enum class Answer { came, ended, stopped };

    void start();
    [[noreturn]] void run_child(int to_parent) const;
    void send_results(int to_parent) const;
    /// Waits for the whole of the next result.
    Answer receive(std::vector<std::uint8_t>& message);
    Answer receive(std::uint8_t* to, std::size_t count);
    /// How the child ended, which has closed its end of the pipe.
    CaseResult child_termination();
    CaseResult stop(int signal);
    int wait_for_child();

    std::size_t count_;
    Work work_;
    std::size_t next_ = 0;
    pid_t child_ = -1;
    int from_child_ = -1;
};

}  // namespace fumon
