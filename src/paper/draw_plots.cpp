#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/plot/plot.h"
#include "figure/words/words.h"
#include "paper/curve_remarks.h"
#include "paper/figure_curve.h"
#include "paper/figure_tables.h"
#include "paper/panel_makers.h"
#include "paper/plot_limits.h"

namespace fumon {

namespace {

constexpr std::size_t few_points = 40;  // up to which a curve's points are marked

SeriesKind kind_of(const CurveSettings& settings, const CurvePoints& points) {
    switch (settings.style) {
        case CurveStyle::line:
            return SeriesKind::line;
        case CurveStyle::points:
            return SeriesKind::points;
        case CurveStyle::line_and_points:
            return SeriesKind::line_and_points;
        case CurveStyle::steps:
            return SeriesKind::step;
        case CurveStyle::automatic:
            break;
    }
    const bool many = points.x.size() > few_points;
    if (settings.fit == CurveFit::cosine && many) return SeriesKind::line;
    if (settings.fit != CurveFit::none || !settings.average) return SeriesKind::points;
    return many ? SeriesKind::line : SeriesKind::line_and_points;
}

/// `whole`: the runs behind a point that has all of them.
PlotSeries series_of(const CurveSettings& settings, const CurvePoints& points,
                     const SeriesLook& look, std::int64_t whole) {
    PlotSeries series;
    series.label = points.name;
    series.kind = kind_of(settings, points);
    series.x = points.x;
    series.y = points.y;
    for (const double spread : points.spread)
        series.y_error.push_back(std::isfinite(spread) ? spread : 0.0);
    for (const std::int64_t runs : points.runs) series.hollow.push_back(runs < whole);
    series.ink = look.ink;
    series.marker = look.marker;
    series.dashes = look.dashes;
    return series;
}

PlotSeries fit_series(const CurvePoints& points, const SeriesLook& look, bool logarithmic) {
    constexpr int samples = 200;
    PlotSeries series;
    series.label = points.law->text();
    series.kind = SeriesKind::fit;
    series.ink = look.ink;
    series.dashes = {4.0, 2.5};
    for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const double x =
            logarithmic && points.law_low > 0.0
                ? points.law_low * elementary::pow(points.law_high / points.law_low, share)
                : std::lerp(points.law_low, points.law_high, share);
        series.x.push_back(x);
        series.y.push_back(points.law->at(x));
    }
    return series;
}

std::string axis_label(const std::string& given, const std::string& name, const std::string& unit) {
    return label_or(given,
                    quantity_in_words(name.substr(name.rfind('.') + 1), unit));  // a key's last
}

PlotAxis axis_of(const std::string& label, bool logarithmic, const WordOrReal& low,
                 const WordOrReal& high) {
    PlotAxis axis;
    axis.label = label;
    axis.logarithmic = logarithmic;
    if (!low.is_word()) axis.low = low.value;
    if (!high.is_word()) axis.high = high.value;
    return axis;
}

LegendPlace legend_of(PanelLegend legend) {
    switch (legend) {
        case PanelLegend::none:
            return LegendPlace::none;
        case PanelLegend::outside:
            return LegendPlace::right;
        case PanelLegend::upper_left:
            return LegendPlace::upper_left;
        case PanelLegend::upper_right:
            return LegendPlace::upper_right;
        case PanelLegend::lower_left:
            return LegendPlace::lower_left;
        case PanelLegend::lower_right:
            return LegendPlace::lower_right;
        case PanelLegend::automatic:
            break;
    }
    return LegendPlace::automatic;
}

/// The plot of a panel with these curves, in the order of its settings: `curves[c]` are those of
/// curve c.
Plot figure_plot(const PanelSettings& panel, const std::vector<std::vector<CurvePoints>>& curves) {
    Plot plot;
    const CurvePoints* first = nullptr;
    std::size_t next_look = 0;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const CurveSettings& settings = panel.curves[c];
        const std::int64_t whole = runs_of_whole_points(curves[c]);
        for (const CurvePoints& points : curves[c]) {
            if (first == nullptr) first = &points;
            const SeriesLook look = series_look(
                settings.colour > 0 ? static_cast<std::size_t>(settings.colour - 1) : next_look++);
            plot.series.push_back(series_of(settings, points, look, whole));
            if (points.law) plot.series.push_back(fit_series(points, look, panel.x_logarithmic));
        }
    }
    for (const RangeBoxSettings& box : panel.boxes)
        plot.boxes.push_back({box.label, box.x_low, box.x_high, box.y_low, box.y_high});
    const CurvePoints none;
    if (first == nullptr) first = &none;
    plot.x = axis_of(axis_label(panel.x_label, first->x_name, first->x_unit), panel.x_logarithmic,
                     panel.x_low, panel.x_high);
    plot.y = axis_of(axis_label(panel.y_label, first->y_name, first->y_unit), panel.y_logarithmic,
                     panel.y_low, panel.y_high);
    plot.legend = legend_of(panel.legend);
    return plot;
}

bool is_marked(const CurveSettings& settings, const std::vector<CurvePoints>& curves) {
    return std::ranges::any_of(curves, [&settings](const CurvePoints& points) {
        const SeriesKind kind = kind_of(settings, points);
        return kind == SeriesKind::points || kind == SeriesKind::line_and_points;
    });
}

/// The points of a curve, whose faults are told where the scene asks for it.
std::vector<CurvePoints> points_of(const CurvePlan& curve, const PanelTools& tools) {
    try {
        return curve_points(curve, curve_table(curve, tools.runs, tools.store));
    } catch (const InputError& fault) {
        throw InputError(tools.plan.scene.at(curve.path + ".y") + fault.what());
    } catch (const Error& fault) {
        throw Error(tools.plan.scene.at(curve.path + ".fit") + fault.what());
    }
}

std::vector<MadePanel> make_plots(const PanelSubject& subject, PanelTools& tools) {
    std::vector<MadePanel> made(1);
    std::vector<std::vector<CurvePoints>> curves;
    for (const CurvePlan& curve : subject.panel.curves) {
        curves.push_back(points_of(curve, tools));
        for (const CurvePoints& points : curves.back()) {
            made[0].data.push_back(
                {fmt::format("-{}.csv", made[0].data.size() + 1), curve_csv(points)});
        }
    }
    Plot plot = figure_plot(subject.panel.settings, curves);
    made[0].warnings = check_limits(subject.panel, plot, tools.plan.scene);
    for (std::size_t c = 0; c < curves.size(); ++c)
        add_remarks(made[0].remarks, subject.panel.settings, c, curves[c],
                    is_marked(subject.panel.settings.curves[c], curves[c]));
    made[0].content = std::make_unique<PlotPanel>(std::move(plot));
    return made;
}

}  // namespace

const PanelMaker panels::plot{nullptr, make_plots};

}  // namespace fumon
