#include "scene/figure/chart_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/error.h"
#include "numerics/expression.h"

namespace fumon {

namespace {

void check_formula(const CurveSettings& curve, const ChartFault& refuse) {
    if (curve.expression.empty()) {
        refuse("expression", "is missing; write y as a formula of x");
        return;
    }
    std::vector<NamedNumber> constants;
    for (const std::string& text : curve.constants) {
        try {
            constants.push_back(read_named_number(text));
        } catch (const InputError& fault) {
            refuse("constants", fault.what());
            return;
        }
        if (constants.back().first == "x")
            refuse("constants", "x is the variable; give the constant another name");
    }
    try {
        const Expression formula(curve.expression, constants);
    } catch (const InputError& fault) {
        refuse("expression", fault.what());
    }
    if (!curve.x_from.is_word() && !curve.x_to.is_word() &&
        !(curve.x_from.value < curve.x_to.value))
        refuse("x_to", "must be above x_from");
}

/// A formula has no table, and a table no formula.
void check_expression(const PanelSettings& panel, const CurveSettings& curve,
                      const ChartFault& refuse) {
    const bool is_formula = curve.table == CurveTable::expression;
    if (!is_formula) {
        const bool from = !curve.x_from.is_word() || !curve.x_to.is_word();
        if (!curve.expression.empty())
            refuse("expression", "is given but not read; write table = \"expression\"");
        if (!curve.constants.empty()) refuse("constants", "belong to a formula, and there is none");
        if (from) refuse(curve.x_from.is_word() ? "x_to" : "x_from", "belongs to a formula");
        return;
    }
    if (panel.kind == PanelKind::heat_map || panel.kind == PanelKind::box_plot) {
        refuse("table", "a formula's line belongs to plot, scatter and histogram panels");
        return;
    }
    const CurveSettings usual;
    const bool has_rows = !curve.scene.empty() || !curve.set.empty() || !curve.over.empty() ||
                          curve.seeds > 0 || !curve.file.empty() || !curve.y.empty() ||
                          !curve.where.empty() || !curve.group_by.empty() ||
                          curve.fit != usual.fit || curve.spread != usual.spread ||
                          curve.scale_x != usual.scale_x || curve.scale_y != usual.scale_y ||
                          curve.offset_y != usual.offset_y;
    if (has_rows) {
        refuse(
            "table",
            "a formula has no rows; drop scene, set, over, seeds, file, y, where, group_by, spread "
            "and fit");
    }
    const bool no_axis = panel.x_low.is_word() && panel.kind != PanelKind::histogram;
    const bool alone = std::ranges::all_of(
        panel.curves, [](const CurveSettings& one) { return one.table == CurveTable::expression; });
    if (alone &&
        ((curve.x_from.is_word() && no_axis) || (curve.x_to.is_word() && panel.x_high.is_word())))
        refuse(curve.x_from.is_word() ? "x_from" : "x_to",
               "no data set its range; give x_from and x_to");
    check_formula(curve, refuse);
}

}  // namespace

void check_chart(const PanelSettings& panel, const ChartFault& refuse) {
    const ChartSettings& chart = panel.chart;
    if (std::ranges::adjacent_find(chart.levels, std::ranges::greater_equal()) !=
        chart.levels.end())
        refuse("levels", "must rise, and each occurs once");
    if (!chart.classes.empty() && chart.classes.size() != chart.levels.size() + 1) {
        refuse("classes",
               fmt::format("there are {} between {} levels; give {}", chart.classes.size(),
                           chart.levels.size(), chart.levels.size() + 1));
    }
    if (panel.kind == PanelKind::heat_map && panel.curves.size() > 1)
        refuse("kind", "a heat map has one curve: one table of cells");
    if (panel.kind != PanelKind::plot && panel.kind != PanelKind::scatter && !panel.boxes.empty() &&
        shown_by(panel.kind) == PanelShows::curves)
        refuse("kind", "boxes belong to plot and scatter panels");
    if (panel.kind == PanelKind::histogram) {
        if (!chart.bin_low.is_word() && !chart.bin_high.is_word() &&
            !(chart.bin_low.value < chart.bin_high.value))
            refuse("bin_high", "must be above bin_low");
        if (panel.x_logarithmic && !chart.bin_low.is_word() && chart.bin_low.value <= 0.0)
            refuse("bin_low", "a logarithmic axis takes only values above 0");
    }
    if (panel.kind == PanelKind::difference && chart.minus_scene.empty() &&
        chart.minus_set.empty() && chart.minus_step < 0)
        refuse("kind", "name what is subtracted by minus_scene, minus_set or minus_step");
}

void check_chart_curve(const PanelSettings& panel, const CurveSettings& curve,
                       const ChartFault& refuse) {
    check_expression(panel, curve, refuse);
    const bool is_formula = curve.table == CurveTable::expression;
    const bool coloured = panel.kind == PanelKind::heat_map || panel.kind == PanelKind::scatter;
    if (coloured && curve.z.empty() && !is_formula)
        refuse("z", "is missing; name the column of the colours");
    if ((!coloured || is_formula) && !curve.z.empty())
        refuse("z",
               "is the column of colours in heat-map and scatter panels; other curves have x and y "
               "only");
    if (panel.kind != PanelKind::plot) {
        if (curve.fit != CurveFit::none) refuse("fit", "belongs to plot panels");
        if (curve.spread != CurveSpread::none) refuse("spread", "belongs to plot panels");
        if (curve.style != CurveStyle::automatic) refuse("style", "belongs to plot panels");
        if (curve.least > 1 && panel.kind != PanelKind::heat_map)
            refuse("least", "belongs to plot and heat-map panels");
    }
    if (panel.kind == PanelKind::heat_map && !curve.group_by.empty())
        refuse("group_by", "a heat map is one table of cells; choose rows with where");
    if (curve.bars == SpreadLook::band && curve.spread == CurveSpread::none)
        refuse("bars", "there is no spread to draw; write spread = \"deviation\" or another");
}

}  // namespace fumon
