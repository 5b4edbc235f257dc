#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"
#include "foreign/time_series.h"

namespace fumon {

struct MeasurementPlot {
    std::string svg;
    std::string description;  ///< of what it shows, with the range of the values
};

/// Plots of a run's measurements over its time: one for each of its first columns that
/// change, at most four. Throws InputError for a damaged table.
std::vector<MeasurementPlot> measurement_plots(const std::filesystem::path& measurements);

/// The same of numbers for each record of another model's run.
std::vector<MeasurementPlot> series_plots(const std::vector<TimeSeries>& series,
                                          const ForeignTimes& times);

}  // namespace fumon
