#pragma once

#include <vector>

#include "figure/page/page.h"
#include "paper/panel_makers.h"

namespace fumon {

/// A figure ready to be drawn.
struct FigurePage {
    Page page;
    std::vector<FigureData> data;
};

/// Feeds a figure's panels from its runs, which are all there. Throws InputError, located, where no
/// row is left for a curve, and where the page is too small for its panels; Error where a fit fails
/// or OpenGL does.
FigurePage figure_page(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                       const FigureDrawing& drawing);

}  // namespace fumon
