#pragma once

#include <vector>

#include "run/parallel_runs.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// The runs of these numbers that are not done, as tasks that leave their files in the folder;
/// records[k] is that of run numbers[k], and task k + 1. A run that another program has made in the
/// meantime is taken from the folder. Plan and folder outlive the tasks.
std::vector<RunTask> sweep_tasks(const SweepPlan& plan, const SweepFolder& folder,
                                 const std::vector<std::size_t>& numbers,
                                 const std::vector<RunRecord>& records);

}  // namespace fumon
