#pragma once

#include <vector>

#include "run/parallel_runs.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// The runs of a sweep that are pending, as tasks that leave their files in its folder.
/// records[n - 1] is run n's. Plan and folder outlive the tasks.
std::vector<RunTask> sweep_tasks(const SweepPlan& plan, const SweepFolder& folder,
                                 const std::vector<RunRecord>& records);

}  // namespace fumon
