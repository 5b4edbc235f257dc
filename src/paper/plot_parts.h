#pragma once

#include <string>
#include <vector>

#include "figure/panels/colour_bar.h"
#include "figure/plot/plot.h"
#include "figure/plot/plot_scale.h"
#include "paper/figure_curve.h"
#include "paper/panel_makers.h"

namespace fumon {

/// The label of an axis: that which is given, else of the column (of a key its last part) and its
/// unit.
std::string axis_label(const std::string& given, const std::string& name, const std::string& unit);

/// The axes of a panel's plot, over a column.
PlotAxis x_axis_of(const PanelSettings& panel, const std::string& name, const std::string& unit);
PlotAxis y_axis_of(const PanelSettings& panel, const std::string& name, const std::string& unit);

LegendPosition legend_of(PanelLegend legend);

/// The points of a curve, whose faults are told where the scene asks for it; none of a formula.
std::vector<CurvePoints> points_of(const CurvePlan& curve, const PanelTools& tools);

/// Adds the x of the points that are drawn.
void add_x(ValueRange& range, const CurvePoints& points);

/// The line of a formula, over x from and to what it says, else the axis's limits, else `range`.
/// Throws InputError, located, where there is no such range or the formula has no value in it.
CurvePoints formula_points(const CurvePlan& curve, const PanelSettings& panel,
                           const ValueRange& range, const PanelTools& tools);

/// That line as it is drawn beside values: black.
PlotSeries formula_series(const CurvePoints& line);

/// The colours of a chart's numbers, which are given sorted: the panel's palette from its low to
/// its high, by default over all of them. Throws as tails_of().
ColourScale chart_colours(const PanelSettings& panel, const Scene& scene,
                          const std::vector<double>& sorted);

}  // namespace fumon
