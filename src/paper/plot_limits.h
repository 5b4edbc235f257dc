#pragma once

#include <string>
#include <vector>

#include "figure/plot/plot.h"
#include "paper/figure_plan.h"

namespace fumon {

/// What the user should hear of curves that lie outside the limits of a panel's axes: one line a
/// curve. Throws InputError, at the first limit that the panel gives, where nothing of the plot
/// lies within them.
std::vector<std::string> check_limits(const PanelPlan& panel, const Plot& plot, const Scene& scene);

}  // namespace fumon
