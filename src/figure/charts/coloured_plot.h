#pragma once

#include <vector>

#include "figure/panels/colour_bar.h"
#include "figure/plot/plot.h"

namespace fumon {

/// A plot whose points have colours that a bar right of it explains.
class ColouredPlotPanel : public PanelContent {
  public:
    /// `values[n]` are those of series n, as many as its points, or none where it has its own ink.
    /// Throws what PlotPanel throws.
    ColouredPlotPanel(Plot plot, std::vector<std::vector<double>> values, ColourScale colours,
                      BarPosition bar);

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    /// To be changed before it is drawn.
    ColourScale& colours() { return colours_; }
    BarPosition& colour_bar() { return bar_; }

  private:
    Plot plot_;
    std::vector<std::vector<double>> values_;
    ColourScale colours_;
    BarPosition bar_;
};

}  // namespace fumon
