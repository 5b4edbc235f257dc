#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "run/terminal/status_line.h"

namespace fumon {

enum class RunStatus { pending, done, failed };

/// What became of a run.
struct RunRecord {
    RunStatus status = RunStatus::pending;
    std::int64_t steps = 0;
    double wall_seconds = 0.0;
    std::string state;    ///< SHA-256 of the final state, hexadecimal
    std::string message;  ///< why it failed, on one line
};

/// How an attempt at a run ended: `busy` when another program is at it.
enum class Attempt { done, interrupted, busy };

/// A run that waits to be done.
struct RunTask {
    std::size_t number = 0;  ///< its record is records[number - 1]
    std::string name;        ///< "run 3 (model.creep_rate=0.2, seed 3)"
    double work = 0.0;       ///< cell-steps
    /// Does it on so many threads, fills the record and adds to the cell-steps done; what it throws
    /// makes the run a failed one.
    std::function<Attempt(int threads, RunRecord& record, std::atomic<double>& cell_steps)> body;
};

/// "12 of 40 runs, 3 failed, 0:34 elapsed, about 1:20 left".
std::string run_progress_text(std::size_t done, std::size_t runs, std::size_t failed,
                              double seconds, double share);

/// Does all tasks in their order, `threads` at once (0: one per processor), each on a thread of its
/// own, or on several where there are fewer runs than threads. A run that fails is told on standard
/// error and the others go on; a busy one is tried again behind the others; an interrupt drops the
/// runs in flight, which stay pending.
void do_runs(const std::vector<RunTask>& tasks, int threads, StatusLine& status,
             std::vector<RunRecord>& records);

}  // namespace fumon
