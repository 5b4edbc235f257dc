#pragma once

#include <vector>

#include "app/figure_curve.h"
#include "figure/plot.h"

namespace fumon {

/// The plot of a panel with these curves, in the order of its settings: `curves[c]` are those of
/// curve c.
Plot figure_plot(const PanelSettings& panel, const std::vector<std::vector<CurvePoints>>& curves);

}  // namespace fumon
