#pragma once

#include <string>
#include <vector>

#include "foreign/foreign_run.h"

namespace fumon {

/// A number for each record of another model's run: a gauge's level, a volume …
struct TimeSeries {
    std::string name;
    std::string unit;  ///< in the file; empty where it names none
    std::vector<double> values;
};

/// Those of a run of one NetCDF file, in the file's order: its variables over the records alone,
/// without the times themselves. None of other runs. Throws InputError for a damaged file.
std::vector<TimeSeries> time_series(const ForeignRun& run);

}  // namespace fumon
