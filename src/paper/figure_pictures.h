#pragma once

#include <vector>

#include "paper/panel_makers.h"

namespace fumon {

/// Makes the panels of a figure from its runs. Keeps one OpenGL context for all 3-D views. Lives on
/// one thread.
class FigurePictures {
  public:
    FigurePictures(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                   const FigureDrawing& drawing);

    /// The panels that panels_of() counts; `width` is the room for a frame on the page, points.
    /// Throws InputError for a damaged file of the store, and what PanelMaker::make throws.
    std::vector<MadePanel> make(const PanelPlan& panel, double width);

  private:
    PanelTools tools_;
};

}  // namespace fumon
