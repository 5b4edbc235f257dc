#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fumon {

/// Plots of a run's measurements over its time, SVG files: one for each of its first columns that
/// change, at most four. Throws InputError for a damaged table.
std::vector<std::string> measurement_plots(const std::filesystem::path& measurements);

}  // namespace fumon
