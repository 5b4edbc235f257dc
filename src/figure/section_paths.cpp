#include "figure/section_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fumon {

LinePanel paths_panel(const Snapshot& snapshot, double unit, const std::string& symbol) {
    const SnapshotSection& section = *snapshot.section;
    std::set<double> angles;
    for (const GrainPath& path : section.paths) angles.insert(path.launch_angle);
    const auto& heights = snapshot.bed.values();
    double highest =
        *std::max_element(heights.begin(), heights.end()) * snapshot.scale.height_unit / unit;
    double east = snapshot.bed.nx() * section.dx / unit;
    LinePanel panel;
    std::set<double> named;
    for (const GrainPath& path : section.paths) {
        const auto place = std::distance(angles.begin(), angles.find(path.launch_angle));
        const bool first = named.insert(path.launch_angle).second;
        LineSeries line{first ? fmt::format("{:g}°", path.launch_angle) : "",
                        series_ink(static_cast<std::size_t>(place), angles.size()),
                        {},
                        false};
        for (std::size_t i = 0; i < path.x.size(); ++i) {
            line.points.emplace_back(path.x[i] / unit, path.z[i] / unit);
            east = std::max(east, path.x[i] / unit);
            highest = std::max(highest, path.z[i] / unit);
        }
        panel.series.push_back(std::move(line));
    }
    panel.x = {0.0, east, fmt::format("x ({})", symbol)};
    panel.y = {0.0, highest > 0.0 ? 1.1 * highest : 1.0, fmt::format("z ({})", symbol)};
    return panel;
}

}  // namespace fumon
