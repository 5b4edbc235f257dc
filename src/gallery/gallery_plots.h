#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fumon {

struct MeasurementPlot {
    std::string svg;
    std::string description;  ///< of what it shows, with the range of the values
};

/// Plots of a run's measurements over its time: one for each of its first columns that
/// change, at most four. Throws InputError for a damaged table.
std::vector<MeasurementPlot> measurement_plots(const std::filesystem::path& measurements);

}  // namespace fumon
