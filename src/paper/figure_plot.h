#pragma once

#include <vector>

#include "figure/plot/plot.h"
#include "paper/figure_curve.h"

namespace fumon {

/// The plot of a panel with these curves, in the order of its settings: `curves[c]` are those of
/// curve c.
Plot figure_plot(const PanelSettings& panel, const std::vector<std::vector<CurvePoints>>& curves);

}  // namespace fumon
