#pragma once

#include "verify/verify_case.h"

namespace fumon {

/// Makes the figure of a case's scene from runs of its own and draws it as pixels. Its state is
/// that of its runs. Throws InputError where the figure is wrong, Error where a run or a drawing
/// library fails.
DrawnCase draw_figure_case(const Baseline& baseline, const BaselineCase& one,
                           const WorkOptions& work);

}  // namespace fumon
