#pragma once

#include <cstdint>

#include "foreign/foreign_run.h"
#include "paper/figure_plan.h"

namespace fumon {

/// The columns that a curve's table has, without rows, as a run with such snapshots gives them; the
/// values of `first` do not matter. Throws
/// InputError without a place where this model has no such table.
Table curve_columns(CurveTable table, const Scene& scene, const Snapshot& first);

/// The rows of a curve of another model's results: the measures of each record, or the profile of
/// that of a step. Throws InputError without a place for other tables, and where
/// there is no record of the step.
Table results_table(CurveTable table, const Scene& scene, const ForeignRun& results,
                    std::int64_t step);

/// The rows that a curve is drawn from: of every run, with the varied keys and the seed as columns
/// before them. Sizes of avalanches are counted over all seeds of a combination together (seed
/// "1:5"). Throws InputError for a damaged file of the store.
Table curve_table(const CurvePlan& curve, const FigureRuns& runs, const RunStore& store);

}  // namespace fumon
