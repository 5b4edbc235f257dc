#pragma once

#include <vector>

#include "figure/page/page.h"
#include "paper/panel_makers.h"

namespace fumon {

/// A figure ready to be drawn.
struct FigurePage {
    Page page;
    std::vector<FigureData> data;
    std::vector<std::vector<std::string>> remarks;  ///< for the caption, of each panel of the plan
    std::vector<std::string> warnings;              ///< what the user should hear
};

/// Builds the panels of a figure from its runs, all of which must be stored. Throws a located
/// InputError if a curve has no rows left or the page is too small for its panels, and Error if a
/// fit or OpenGL fails.
FigurePage figure_page(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                       const FigureDrawing& drawing);

}  // namespace fumon
