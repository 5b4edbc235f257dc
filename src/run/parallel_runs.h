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

/// The outcome of a run.
struct RunRecord {
    RunStatus status = RunStatus::pending;
    std::int64_t steps = 0;
    double wall_seconds = 0.0;
    std::string state;    ///< SHA-256 of the final state, hexadecimal
    std::string message;  ///< why it failed, or what is to be doubted about it; on one line
};

/// How an attempt at a run ended; `busy`: another program is working on it.
enum class Attempt { done, interrupted, busy };

/// A run that has yet to be made.
struct RunTask {
    std::size_t number = 0;  ///< its record is records[number - 1]
    std::string name;        ///< "run 3 (model.creep_rate=0.2, seed 3)"
    double work = 0.0;       ///< cell-steps
    /// Makes the run on that many threads, fills in its record and adds to the cell-steps done. If
    /// it throws, the run counts as failed.
    std::function<Attempt(int threads, RunRecord& record, std::atomic<double>& cell_steps)> body;
};

/// "12 of 40 runs, 3 failed, 0:34 elapsed, about 1:20 left".
std::string run_progress_text(std::size_t done, std::size_t runs, std::size_t failed,
                              double seconds, double share);

/// Makes all runs in order, `threads` at a time (0: one per processor), each on one thread, or on
/// several if there are fewer runs than threads. A run that fails is reported on standard error and
/// the others continue; a busy one is tried again after the others; an interrupt drops the runs in
/// flight, which stay pending.
void do_runs(const std::vector<RunTask>& tasks, int threads, StatusLine& status,
             std::vector<RunRecord>& records);

}  // namespace fumon
