#pragma once

#include <string>
#include <vector>

#include "paper/figure_plan.h"

namespace fumon {

/// The caption of a figure: its own sentences; what all runs share, with all parameters that are
/// not the model's defaults; for every panel what it shows, the parameters in which its run differs
/// from others, defaults too, what varies, seeds, steps and `remarks` (see FigurePage); the sources
/// of labelled ranges; the version at last.
std::string figure_caption(const FigurePlan& plan,
                           const std::vector<std::vector<std::string>>& remarks);

}  // namespace fumon
