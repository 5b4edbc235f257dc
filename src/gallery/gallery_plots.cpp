#include "gallery/gallery_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "figure/canvas/canvas.h"
#include "figure/plot/plot.h"
#include "files/csv_table.h"
#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::size_t most_plots = 4;
constexpr double width = 320.0;  // points
constexpr double height = 200.0;
constexpr double font_size = 11.0;
constexpr double edge = 8.0;  // points

/// What tells little of a landform: it is conserved, or only grows with what is strewn.
constexpr std::array<std::string_view, 4> of_little_news{"step", "time", "mean_height",
                                                         "total_sand"};

std::vector<double> known_values(const TableColumn& column) {
    std::vector<double> values;
    for (const double value : column.values)
        if (std::isfinite(value)) values.push_back(value);
    return values;
}

/// Whether there is something to see: three values that are not all alike.
bool changes(const TableColumn& column) {
    const std::vector<double> values = known_values(column);
    constexpr std::size_t least = 3;
    if (values.size() < least) return false;
    const double low = std::ranges::min(values);
    const double high = std::ranges::max(values);
    constexpr double rounding = 1e-9;
    return high - low > rounding * std::max(std::abs(low), std::abs(high));
}

std::string in_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string described(const TableColumn& time, const TableColumn& column) {
    const std::vector<double> values = known_values(column);
    return fmt::format("Plot of the {} over {}: between {:.3g} and {:.3g}, at the end {:.3g}",
                       in_words(column.name), in_words(time.name), std::ranges::min(values),
                       std::ranges::max(values), values.back());
}

std::string label_of(const TableColumn& column) {
    const std::string words = in_words(column.name);
    const bool has_unit = !column.unit.empty() && column.unit != "1" && column.unit != "-";
    return has_unit ? fmt::format("{} ({})", words, column.unit) : words;
}

std::string drawn(const TableColumn& time, const TableColumn& column) {
    Plot plot;
    plot.x.label = label_of(time);
    plot.y.label = label_of(column);
    PlotSeries line;
    line.x = time.values;
    line.y = column.values;
    plot.series.push_back(std::move(line));
    const PlotPanel panel(std::move(plot));
    Canvas canvas(PageFormat::svg, width, height, 96.0, font_size);
    constexpr double across = width - 2.0 * edge;
    constexpr double down = height - 2.0 * edge;
    const PanelMargins margins = panel.margins(canvas, across, down);
    panel.draw(canvas,
               {edge + margins.left, edge + margins.above, across - margins.left - margins.right,
                down - margins.above - margins.below});
    canvas.set_metadata({{"Title", column.name}, {"Software", "fumon"}});
    return canvas.bytes();
}

/// Of the columns that change and say something new, at most four.
std::vector<MeasurementPlot> plots_of(const TableColumn& time,
                                      const std::vector<TableColumn>& columns) {
    std::vector<MeasurementPlot> plots;
    for (const TableColumn& column : columns) {
        const bool little = std::ranges::find(of_little_news, column.name) != of_little_news.end();
        if (little || !changes(column)) continue;
        plots.push_back({drawn(time, column), described(time, column)});
        if (plots.size() == most_plots) break;
    }
    return plots;
}

}  // namespace

std::vector<MeasurementPlot> measurement_plots(const std::filesystem::path& measurements) {
    const Table table = parse_csv_table({measurements.string(), read_input_file(measurements)});
    const TableColumn* time = table.find("time");
    if (time == nullptr) return {};
    return plots_of(*time, table.columns);
}

std::vector<MeasurementPlot> series_plots(const std::vector<TimeSeries>& series,
                                          const ForeignTimes& times) {
    const bool has_unit = times.unit != "steps";
    std::vector<TableColumn> columns;
    columns.reserve(series.size());
    for (const TimeSeries& one : series) columns.push_back({one.name, one.unit, one.values});
    return plots_of({has_unit ? "time" : "step", has_unit ? times.unit : "", times.times}, columns);
}

}  // namespace fumon
