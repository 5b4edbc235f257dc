#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/charts/coloured_plot.h"
#include "figure/words/words.h"
#include "files/csv_table.h"
#include "numerics/distribution.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "paper/plot_limits.h"
#include "paper/plot_parts.h"

namespace fumon {

namespace {

/// Points with a third number.
struct ColouredPoints {
    CurvePoints points;
    std::vector<double> z;
    std::string z_name, z_unit;
};

std::vector<ColouredPoints> coloured_points(const CurvePlan& curve, const PanelTools& tools) {
    const CurveSettings& settings = curve.settings;
    const Table table = curve_table(curve, tools.runs, tools.store);
    const TableRows rows = chosen_rows(table, settings);
    const auto& [x, y, z] =
        std::tuple{table.find(settings.x), table.find(settings.y), table.find(settings.z)};
    std::vector<ColouredPoints> all;
    for (const TableRows& group : groups_of_rows(table, settings, rows)) {
        ColouredPoints made;
        CurvePoints& points = made.points;
        points.name = curve_name(curve, table, group);
        points.x_name = settings.x;
        points.y_name = settings.y;
        if (settings.scale_x == 1.0) points.x_unit = x->unit;
        if (settings.scale_y == 1.0) points.y_unit = y->unit;
        made.z_name = settings.z;
        made.z_unit = z->unit;
        for (const std::size_t row : group) {
            if (!std::isfinite(x->values[row]) || !std::isfinite(y->values[row]) ||
                !std::isfinite(z->values[row]))
                continue;
            points.x.push_back(x->values[row] * settings.scale_x);
            points.y.push_back((y->values[row] + settings.offset_y) * settings.scale_y);
            made.z.push_back(z->values[row]);
        }
        if (!made.z.empty()) all.push_back(std::move(made));
    }
    if (all.empty()) throw InputError("no row has numbers in x, y and z and meets the conditions");
    return all;
}

std::string csv_of(const ColouredPoints& made) {
    const auto column = [](const std::string& name, const std::string& unit) {
        return unit.empty() ? name : fmt::format("{} ({})", name, unit);
    };
    const CurvePoints& points = made.points;
    std::string text =
        csv_line({column(points.x_name, points.x_unit), column(points.y_name, points.y_unit),
                  column(made.z_name, made.z_unit)});
    for (std::size_t i = 0; i < made.z.size(); ++i)
        text += csv_line({fmt::format("{}", points.x[i]), fmt::format("{}", points.y[i]),
                          fmt::format("{}", made.z[i])});
    return text;
}

std::vector<MadePanel> make_scatters(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    std::vector<std::vector<ColouredPoints>> curves;
    std::vector<double> all;
    ValueRange range;
    const ColouredPoints* first = nullptr;
    for (const CurvePlan& curve : subject.panel.curves) {
        curves.emplace_back();
        if (curve.settings.table == CurveTable::expression) continue;
        try {
            curves.back() = coloured_points(curve, tools);
        } catch (const InputError& fault) {
            throw placed(tools.plan.scene.at(curve.path + ".z"), fault);
        }
        for (const ColouredPoints& one : curves.back()) {
            all.insert(all.end(), one.z.begin(), one.z.end());
            add_x(range, one.points);
        }
    }
    for (const auto& curve : curves) {
        if (first == nullptr && !curve.empty()) first = &curve.front();
    }
    std::ranges::sort(all);
    std::vector<MadePanel> made(1);
    Plot plot;
    std::vector<std::vector<double>> values;
    std::size_t next_look = 0;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const CurvePlan& curve = subject.panel.curves[c];
        if (curve.settings.table == CurveTable::expression) {
            const CurvePoints line = formula_points(curve, settings, range, tools);
            plot.series.push_back(formula_series(line));
            values.emplace_back();
            made[0].data.push_back(
                {fmt::format("-{}.csv", made[0].data.size() + 1), curve_csv(line)});
            continue;
        }
        for (const ColouredPoints& one : curves[c]) {
            PlotSeries series;
            series.label = one.points.name;
            series.kind = SeriesKind::points;
            series.x = one.points.x;
            series.y = one.points.y;
            series.marker = series_look(next_look++).marker;
            series.ink = black_ink;
            plot.series.push_back(std::move(series));
            values.push_back(one.z);
            made[0].data.push_back({fmt::format("-{}.csv", made[0].data.size() + 1), csv_of(one)});
        }
    }
    for (const RangeBoxSettings& box : settings.boxes)
        plot.boxes.push_back({box.label, box.x_low, box.x_high, box.y_low, box.y_high});
    if (first == nullptr) {
        throw InputError(tools.plan.scene.at(subject.panel.path + ".kind") +
                         "the scatter plot has no points; add a [[figure.panel.curve]] with z");
    }
    plot.x = x_axis_of(settings, first->points.x_name, first->points.x_unit);
    plot.y = y_axis_of(settings, first->points.y_name, first->points.y_unit);
    plot.legend = legend_of(settings.legend);
    made[0].warnings = check_limits(subject.panel, plot, tools.plan.scene);
    ColourScale colours = chart_colours(settings, tools.plan.scene, all);
    colours.label = label_or(settings.bar_label, quantity_in_words(first->z_name, first->z_unit));
    const PanelColours::Values shown = std::pair{all.front(), all.back()};
    mark_range_ends(colours, shown);
    if (!settings.chart.share_colours) made[0].remarks.push_back(range_sentence(colours, shown));
    made[0].remarks.push_back(phrase("{} points, one for each row", all.size()));
    auto content = std::make_unique<ColouredPlotPanel>(
        std::move(plot), std::move(values), std::move(colours),
        settings.colour_bar ? BarPosition::right : BarPosition::none);
    if (settings.chart.share_colours)
        made[0].shared = {&content->colours(), &content->colour_bar(), shown};
    made[0].content = std::move(content);
    return made;
}

}  // namespace

const PanelMaker panels::scatter{nullptr, make_scatters};

}  // namespace fumon
