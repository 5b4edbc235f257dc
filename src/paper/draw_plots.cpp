#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary_power.h"
#include "figure/plot/plot.h"
#include "figure/words/words.h"
#include "paper/curve_remarks.h"
#include "paper/figure_curve.h"
#include "paper/figure_tables.h"
#include "paper/panel_makers.h"
#include "paper/plot_limits.h"
#include "paper/plot_parts.h"

namespace fumon {

namespace {

constexpr std::size_t few_points = 40;  // up to which a curve's points are marked

SeriesKind kind_of(const CurveSettings& settings, const CurvePoints& points) {
    if (settings.table == CurveTable::expression) return SeriesKind::line;
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
    series.with_band = settings.bars == SpreadLook::band;
    if (settings.bars == SpreadLook::bars) {
        for (const double spread : points.spread)
            series.y_error.push_back(std::isfinite(spread) ? spread : 0.0);
    }
    for (const std::int64_t runs : points.runs) series.hollow.push_back(runs < whole);
    series.ink = look.ink;
    series.marker = look.marker;
    series.dashes = look.dashes;
    return series;
}

/// As far above and below a curve as its spread; of one run none.
PlotSeries band_of(const CurvePoints& points, const SeriesLook& look) {
    PlotSeries band;
    band.kind = SeriesKind::band;
    band.x = points.x;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        const double spread = std::isfinite(points.spread[i]) ? points.spread[i] : 0.0;
        band.y.push_back(points.y[i] + spread);
        band.y_low.push_back(points.y[i] - spread);
    }
    band.ink = look.ink;
    return band;
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
            if (first == nullptr || !first->formula.empty()) first = &points;
            const SeriesLook look = series_look(
                settings.colour > 0 ? static_cast<std::size_t>(settings.colour - 1) : next_look++);
            if (settings.bars == SpreadLook::band) plot.series.push_back(band_of(points, look));
            plot.series.push_back(series_of(settings, points, look, whole));
            if (points.law) plot.series.push_back(fit_series(points, look, panel.x_logarithmic));
        }
    }
    for (const RangeBoxSettings& box : panel.boxes)
        plot.boxes.push_back({box.label, box.x_low, box.x_high, box.y_low, box.y_high});
    const CurvePoints none;
    if (first == nullptr) first = &none;
    plot.x = x_axis_of(panel, first->x_name, first->x_unit);
    plot.y = y_axis_of(panel, first->y_name, first->y_unit);
    plot.legend = legend_of(panel.legend);
    return plot;
}

bool is_marked(const CurveSettings& settings, const std::vector<CurvePoints>& curves) {
    return std::ranges::any_of(curves, [&settings](const CurvePoints& points) {
        const SeriesKind kind = kind_of(settings, points);
        return kind == SeriesKind::points || kind == SeriesKind::line_and_points;
    });
}

std::vector<MadePanel> make_plots(const PanelSubject& subject, PanelTools& tools) {
    std::vector<MadePanel> made(1);
    std::vector<std::vector<CurvePoints>> curves;
    ValueRange range;
    for (const CurvePlan& curve : subject.panel.curves) {
        curves.push_back(points_of(curve, tools));
        for (const CurvePoints& points : curves.back()) add_x(range, points);
    }
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const CurvePlan& curve = subject.panel.curves[c];
        if (curve.settings.table == CurveTable::expression)
            curves[c] = {formula_points(curve, subject.panel.settings, range, tools)};
        for (const CurvePoints& points : curves[c]) {
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
