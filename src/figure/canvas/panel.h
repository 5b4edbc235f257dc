#pragma once

#include "figure/canvas/canvas.h"

namespace fumon {

/// What a panel needs around its frame for ticks, labels and bars, in the canvas's units.
struct PanelMargins {
    double left = 0.0;
    double right = 0.0;
    double above = 0.0;
    double below = 0.0;
};

/// What stands in one panel of a page: a plot, a map, a view …
class PanelContent {
  public:
    PanelContent() = default;
    PanelContent(const PanelContent&) = delete;
    PanelContent& operator=(const PanelContent&) = delete;
    virtual ~PanelContent() = default;

    /// Width over height that its frame must have; 0 where any will do.
    [[nodiscard]] virtual double aspect() const { return 0.0; }
    /// The room for all that it draws outside a frame of this width and height.
    [[nodiscard]] virtual PanelMargins margins(const Canvas& canvas, double width,
                                               double height) const = 0;
    /// Draws everything, within `frame` and its margins.
    virtual void draw(Canvas& canvas, const CanvasBox& frame) const = 0;
};

}  // namespace fumon
