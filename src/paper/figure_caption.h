#pragma once

#include <string>

#include "paper/figure_plan.h"

namespace fumon {

/// The caption of a figure: its own sentences, then for every panel what it shows: the model with
/// all parameters that are not its defaults, what varies, seeds and steps, the fits, the sources of
/// labelled ranges; the version at last.
std::string figure_caption(const FigurePlan& plan);

}  // namespace fumon
