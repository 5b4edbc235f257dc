#pragma once

#include <filesystem>
#include <vector>

#include "paper/figure_plan.h"
#include "paper/store/run_store.h"
#include "run/terminal/status_line.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// Makes the runs that are not in the store, on all threads, longest first. Reports failed runs,
/// and returns what became of each.
std::vector<RunRecord> make_runs(const FigureRuns& runs, const RunStore& store,
                                 const WorkOptions& work, StatusLine& status);

/// Why a figure cannot be made: its first run that failed; empty if all are stored.
std::string missing_run(const FigurePlan& plan, const FigureRuns& runs,
                        const std::vector<RunRecord>& records);

/// Reports that an interrupt stopped the work, and returns the exit status.
int report_interrupted(StatusLine& status, const std::vector<RunRecord>& records);

}  // namespace fumon
