#include "figure/panels/section_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "figure/panels/section_lines.h"

namespace fumon {

Plot paths_plot(const Snapshot& snapshot, const LengthUnit& unit) {
    const SnapshotSection& section = *snapshot.section;
    std::set<double> angles;
    for (const GrainPath& path : section.paths) angles.insert(path.launch_angle);
    double highest = highest_bed(snapshot) / unit.length;
    double east = snapshot.bed.nx() * section.dx / unit.length;
    Plot plot;
    std::set<double> named;
    for (const GrainPath& path : section.paths) {
        const auto place = std::distance(angles.begin(), angles.find(path.launch_angle));
        const SeriesLook look = series_look(static_cast<std::size_t>(place));
        PlotSeries series;
        if (named.insert(path.launch_angle).second)
            series.label = fmt::format("{:g}°", path.launch_angle);
        series.ink = look.ink;
        series.dashes = LineDashes{};
        for (std::size_t i = 0; i < path.x.size(); ++i) {
            series.x.push_back(path.x[i] / unit.length);
            series.y.push_back(path.z[i] / unit.length);
            east = std::max(east, series.x.back());
            highest = std::max(highest, series.y.back());
        }
        plot.series.push_back(std::move(series));
    }
    plot.x.label = fmt::format("x ({})", unit.symbol);
    plot.x.low = 0.0;
    plot.x.high = east;
    plot.y.label = fmt::format("z ({})", unit.symbol);
    plot.y.low = 0.0;
    plot.y.high = highest > 0.0 ? 1.1 * highest : 1.0;
    return plot;
}

}  // namespace fumon
