#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "app/status_line.h"
#include "app/sweep_folder.h"
#include "app/sweep_plan.h"

namespace fumon {

/// "12 of 40 runs, 3 failed, 0:34 elapsed, about 1:20 left".
std::string sweep_progress_text(std::size_t done, std::size_t runs, std::size_t failed,
                                double seconds, double share);

/// Does every run that is pending, `threads` at once (0: one per processor), each on a thread of
/// its own, or on several where there are fewer runs than threads. A run that fails is told on
/// standard error and the others go on; an interrupt drops the runs in flight, which stay pending.
/// records[n - 1] is run n's, in and out.
void do_runs(const SweepPlan& plan, const SweepFolder& folder, int threads, StatusLine& status,
             std::vector<RunRecord>& records);

}  // namespace fumon
