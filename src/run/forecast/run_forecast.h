#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/prepared_run.h"

namespace fumon {

/// What a run will take.
struct RunForecast {
    double seconds = 0.0;           ///< of wall time, in the model's steps
    int threads = 1;                ///< that took them
    std::int64_t fields_bytes = 0;  ///< of fields.nc before compression
    std::int64_t frames_bytes = 0;  ///< of the frames before compression
    std::int64_t steps_tried = 0;   ///< from which the seconds follow
};

/// Makes some of a run's first steps, for at most `most_seconds` (and a step), and tells what all
/// of them will take. `run` is used up: its model has gone on. Where steps get longer as the run
/// goes on, as over ground that water spreads on, the seconds grow with the power of the steps
/// that was read, at most 1.35; that of rain on a gully is 1.2 to 1.4. Nothing where a step fails.
std::optional<RunForecast> forecast_run(const PreparedRun& run, double most_seconds);

/// The seconds of `steps` steps after the first ones, of which `after` has the seconds from the
/// start to the end of each, one at least.
double forecast_seconds(const std::vector<double>& after, std::int64_t steps);

/// "about 0:40 in steps on 2 threads, at most 824 MB of fields"; empty for what is soon done and
/// small.
std::string forecast_text(const RunForecast& forecast);

}  // namespace fumon
