#include "paper/plot_parts.h"

#include <algorithm>
#include <cmath>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/words/words.h"
#include "numerics/distribution.h"
#include "numerics/expression.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_look.h"

namespace fumon {

std::string axis_label(const std::string& given, const std::string& name, const std::string& unit) {
    return label_or(given,
                    quantity_in_words(name.substr(name.rfind('.') + 1), unit));  // a key's last
}

namespace {

PlotAxis axis_of(const std::string& label, bool logarithmic, const WordOrReal& low,
                 const WordOrReal& high) {
    PlotAxis axis;
    axis.label = label;
    axis.logarithmic = logarithmic;
    if (!low.is_word()) axis.low = low.value;
    if (!high.is_word()) axis.high = high.value;
    return axis;
}

}  // namespace

PlotAxis x_axis_of(const PanelSettings& panel, const std::string& name, const std::string& unit) {
    return axis_of(axis_label(panel.x_label, name, unit), panel.x_logarithmic, panel.x_low,
                   panel.x_high);
}

PlotAxis y_axis_of(const PanelSettings& panel, const std::string& name, const std::string& unit) {
    return axis_of(axis_label(panel.y_label, name, unit), panel.y_logarithmic, panel.y_low,
                   panel.y_high);
}

LegendPosition legend_of(PanelLegend legend) {
    switch (legend) {
        case PanelLegend::none:
            return LegendPosition::none;
        case PanelLegend::outside:
            return LegendPosition::right;
        case PanelLegend::upper_left:
            return LegendPosition::upper_left;
        case PanelLegend::upper_right:
            return LegendPosition::upper_right;
        case PanelLegend::lower_left:
            return LegendPosition::lower_left;
        case PanelLegend::lower_right:
            return LegendPosition::lower_right;
        case PanelLegend::automatic:
            break;
    }
    return LegendPosition::automatic;
}

std::vector<CurvePoints> points_of(const CurvePlan& curve, const PanelTools& tools) {
    if (curve.settings.table == CurveTable::expression) return {};
    try {
        return curve_points(curve, curve_table(curve, tools.runs, tools.store));
    } catch (const InputError& fault) {
        throw InputError(tools.plan.scene.at(curve.path + ".y") + fault.what());
    } catch (const Error& fault) {
        throw Error(tools.plan.scene.at(curve.path + ".fit") + fault.what());
    }
}

void add_x(ValueRange& range, const CurvePoints& points) {
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (std::isfinite(points.x[i]) && std::isfinite(points.y[i])) range.add(points.x[i]);
    }
}

CurvePoints formula_points(const CurvePlan& curve, const PanelSettings& panel,
                           const ValueRange& range, const PanelTools& tools) {
    constexpr int samples = 400;
    const CurveSettings& settings = curve.settings;
    const auto end = [](const WordOrReal& own, const WordOrReal& axis, double data) {
        if (!own.is_word()) return own.value;
        return axis.is_word() ? data : axis.value;
    };
    const double low = end(settings.x_from, panel.x_low, range.low);
    const double high = end(settings.x_to, panel.x_high, range.high);
    const auto refuse = [&](const std::string& what) {
        throw InputError(tools.plan.scene.at(curve.path + ".expression") + what);
    };
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high))
        refuse("no data set its range; give x_from and x_to");
    if (panel.x_logarithmic && !(low > 0.0))
        refuse("a logarithmic axis takes only values above 0; give x_from");
    std::vector<NamedNumber> constants;
    for (const std::string& text : settings.constants) constants.push_back(read_named_number(text));
    const Expression formula(settings.expression, constants);
    CurvePoints points;
    points.name = curve_name(curve, curve.table, {});
    points.x_name = "x";
    points.y_name = "y";
    points.formula = settings.expression;
    for (const std::string& constant : settings.constants) points.formula += "; " + constant;
    bool any = false;
    for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        points.x.push_back(panel.x_logarithmic ? low * elementary::pow(high / low, share)
                                               : std::lerp(low, high, share));
        points.y.push_back(formula.at(points.x.back()));
        any = any || std::isfinite(points.y.back());
    }
    if (!any) refuse("it has no value in this range of x");
    return points;
}

PlotSeries formula_series(const CurvePoints& line) {
    PlotSeries series;
    series.label = line.name;
    series.x = line.x;
    series.y = line.y;
    series.ink = black_ink;
    return series;
}

ColourScale chart_colours(const PanelSettings& panel, const Scene& scene,
                          const std::vector<double>& sorted) {
    const LookSettings look = look_of(panel, scene);
    ColourScale colours;
    colours.palette = read_palette(look.palette == "sand" ? "viridis" : look.palette);
    if (look.palette_reversed) std::ranges::reverse(colours.palette);
    const RangeTails tails = tails_of(panel, 0.0);
    colours.low = panel.low.is_word() ? quantile(sorted, tails.low) : panel.low.value;
    colours.high = panel.high.is_word() ? quantile(sorted, 1.0 - tails.high) : panel.high.value;
    if (!(colours.high > colours.low)) colours.high = colours.low + 1.0;
    return colours;
}

}  // namespace fumon
