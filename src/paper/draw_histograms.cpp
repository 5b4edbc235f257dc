#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/words/words.h"
#include "files/csv_table.h"
#include "numerics/distribution.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_makers.h"
#include "paper/plot_limits.h"
#include "paper/plot_parts.h"

namespace fumon {

namespace {

/// Values of which a histogram counts.
struct Sample {
    std::string name;  ///< in the legend
    std::string column, unit;
    std::vector<double> values;
    std::size_t colour = 0;  ///< number in the cycle, from 1; 0: the next
};

std::vector<Sample> samples_of(const CurvePlan& curve, const PanelTools& tools) {
    const CurveSettings& settings = curve.settings;  // whose x is y
    const Table table = curve_table(curve, tools.runs, tools.store);
    const TableColumn& column = *table.find(settings.y);
    std::vector<Sample> samples;
    for (const TableRows& group : groups_of_rows(table, settings, chosen_rows(table, settings))) {
        Sample sample{curve_name(curve, table, group),
                      settings.y,
                      settings.scale_y == 1.0 ? column.unit : "",
                      {},
                      static_cast<std::size_t>(settings.colour)};
        for (const std::size_t row : group) {
            if (std::isfinite(column.values[row]))
                sample.values.push_back((column.values[row] + settings.offset_y) *
                                        settings.scale_y);
        }
        samples.push_back(std::move(sample));
    }
    if (samples.empty()) throw InputError("no row has a number in y and meets the conditions");
    return samples;
}

/// One set of bins for all samples.
std::vector<double> edges_of(const PanelSettings& panel, const std::vector<Sample>& samples) {
    std::vector<double> all;
    for (const Sample& sample : samples)
        all.insert(all.end(), sample.values.begin(), sample.values.end());
    const ChartSettings& chart = panel.chart;
    const auto [least, greatest] = std::ranges::minmax(all);
    BinSettings bins{chart.bins, chart.bin_low.is_word() ? least : chart.bin_low.value,
                     chart.bin_high.is_word() ? greatest : chart.bin_high.value,
                     panel.x_logarithmic};
    if (bins.logarithmic && !(bins.low > 0.0))
        throw InputError(fmt::format(
            "bins of a logarithmic axis must be above 0, but a value is {:g}; give bin_low",
            bins.low));
    if (bins.low > bins.high)
        throw InputError(
            fmt::format("all values, {:g} to {:g}, lie outside of the bins", least, greatest));
    return bin_edges(all, bins);
}

/// The height of each bin.
std::vector<double> heights_of(const std::vector<std::int64_t>& counts,
                               const std::vector<double>& edges, BarHeight asked) {
    double all = 0.0;
    for (const std::int64_t count : counts) all += static_cast<double>(count);
    std::vector<double> heights;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        double height = static_cast<double>(counts[i]);
        if (asked != BarHeight::count && all > 0.0) height /= all;
        if (asked == BarHeight::density) height /= edges[i + 1] - edges[i];
        heights.push_back(height);
    }
    return heights;
}

const char* name_of(BarHeight asked) {
    if (asked == BarHeight::share) return "share";
    return asked == BarHeight::density ? "density" : "count";
}

/// A stair over the bins, closed along zero; on a logarithmic axis its top alone.
PlotSeries stair_of(const std::vector<double>& heights, const std::vector<double>& edges,
                    bool logarithmic) {
    PlotSeries series;
    series.kind = logarithmic ? SeriesKind::line : SeriesKind::area;
    const auto add = [&series](double x, double y) {
        series.x.push_back(x);
        series.y.push_back(y);
    };
    if (!logarithmic) add(edges.front(), 0.0);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        add(edges[i], heights[i]);
        add(edges[i + 1], heights[i]);
    }
    if (!logarithmic) add(edges.back(), 0.0);
    return series;
}

std::string csv_of(const Sample& sample, const std::vector<double>& edges,
                   const std::vector<std::int64_t>& counts, const std::vector<double>& heights,
                   BarHeight asked) {
    const std::string unit = sample.unit.empty() ? "" : fmt::format(" ({})", sample.unit);
    std::vector<std::string> header{sample.column + " from" + unit, sample.column + " to" + unit,
                                    "count"};
    if (asked != BarHeight::count) header.emplace_back(name_of(asked));
    std::string text = csv_line(header);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        std::vector<std::string> cells{fmt::format("{}", edges[i]), fmt::format("{}", edges[i + 1]),
                                       fmt::format("{}", counts[i])};
        if (asked != BarHeight::count) cells.push_back(fmt::format("{}", heights[i]));
        text += csv_line(cells);
    }
    return text;
}

std::vector<MadePanel> make_histograms(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    const ChartSettings& chart = settings.chart;
    const Scene& scene = tools.plan.scene;
    std::vector<Sample> samples;
    for (const CurvePlan& curve : subject.panel.curves) {
        if (curve.settings.table == CurveTable::expression) continue;
        try {
            for (Sample& sample : samples_of(curve, tools)) samples.push_back(std::move(sample));
        } catch (const InputError& fault) {
            throw placed(scene.at(curve.path + ".y"), fault);
        }
    }
    if (samples.empty())
        throw InputError(scene.at(subject.panel.path + ".kind") + "the histogram counts nothing");
    std::vector<double> edges;
    try {
        edges = edges_of(settings, samples);
    } catch (const InputError& fault) {
        throw placed(scene.at(subject.panel.path + ".kind"), fault);
    }
    std::vector<MadePanel> made(1);
    Plot plot;
    std::size_t next_look = 0;
    for (const Sample& sample : samples) {
        const std::vector<std::int64_t> counts = bin_counts(sample.values, edges);
        const std::vector<double> heights = heights_of(counts, edges, chart.bar_height);
        PlotSeries series = stair_of(heights, edges, settings.y_logarithmic);
        series.label = sample.name;
        series.ink = series_look(sample.colour > 0 ? sample.colour - 1 : next_look++).ink;
        plot.series.push_back(std::move(series));
        std::int64_t counted = 0;
        for (const std::int64_t count : counts) counted += count;
        const auto all = static_cast<std::int64_t>(sample.values.size());
        std::string remark = samples.size() > 1 && !sample.name.empty() ? sample.name + ": " : "";
        remark += phrase("n = {}", counted);
        if (counted < all) remark += phrase(" ({} more lie outside of the bins)", all - counted);
        made[0].remarks.push_back(remark);
        made[0].data.push_back({fmt::format("-{}.csv", made[0].data.size() + 1),
                                csv_of(sample, edges, counts, heights, chart.bar_height)});
    }
    const Sample& first = samples.front();
    const std::string of = first.unit.empty() ? "" : fmt::format(" {}", unit_word(first.unit));
    const std::string low = fmt::format("{:.4g}", edges.front());
    const std::string high = fmt::format("{:.4g}{}", edges.back(), of);
    made[0].remarks.insert(
        made[0].remarks.begin(),
        settings.x_logarithmic
            ? phrase("{} bins of even logarithms from {} to {}", edges.size() - 1, low, high)
            : phrase("{} bins from {} to {}", edges.size() - 1, low, high));
    ValueRange range{edges.front(), edges.back()};
    for (const CurvePlan& curve : subject.panel.curves) {
        if (curve.settings.table != CurveTable::expression) continue;
        const CurvePoints line = formula_points(curve, settings, range, tools);
        plot.series.push_back(formula_series(line));
        made[0].data.push_back({fmt::format("-{}.csv", made[0].data.size() + 1), curve_csv(line)});
    }
    plot.x = x_axis_of(settings, first.column, first.unit);
    if (!settings.x_logarithmic) plot.x.low = edges.front();
    if (!settings.x_logarithmic) plot.x.high = edges.back();
    const std::string unit =
        chart.bar_height == BarHeight::density && !first.unit.empty() ? "1/" + first.unit : "";
    plot.y = y_axis_of(settings, name_of(chart.bar_height), unit);
    if (!plot.y.low && !settings.y_logarithmic) plot.y.low = 0.0;
    plot.legend = legend_of(settings.legend);
    made[0].warnings = check_limits(subject.panel, plot, scene);
    made[0].content = std::make_unique<PlotPanel>(std::move(plot));
    return made;
}

}  // namespace

const PanelMaker panels::histogram{nullptr, make_histograms};

}  // namespace fumon
