#pragma once

#include <string>
#include <vector>

#include "figure/page/page.h"
#include "gl/context.h"
#include "paper/figure_plan.h"

namespace fumon {

/// Data behind something that a figure shows.
struct FigureData {
    std::string name;  ///< the end of its file's name: "a-1.csv"
    std::string text;
};

/// A figure ready to be drawn.
struct FigurePage {
    Page page;
    std::vector<FigureData> data;
};

/// What 3-D views are drawn with.
struct FigureDrawing {
    gl::Backend backend = gl::Backend::automatic;
    int threads = 0;  ///< of the renderer's own loops; 0: one per processor
};

/// Feeds a figure's panels from its runs, which are all there. Throws InputError, located, where no
/// row is left for a curve, and where the page is too small for its panels; Error where a fit fails
/// or OpenGL does.
FigurePage figure_page(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                       const FigureDrawing& drawing);

}  // namespace fumon
