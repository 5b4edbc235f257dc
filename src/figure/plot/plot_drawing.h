#pragma once

#include <optional>
#include <vector>

#include "figure/plot/plot_axes.h"

namespace fumon {

/// Where the legend of a plot stands.
struct LegendBox {
    CanvasBox box;
    int columns = 1;
    bool inside = true;  ///< of the frame
};

/// A label within the frame, in one place of several.
struct PlotLabel {
    std::string text;
    CanvasPoint at;
    CanvasPoint anchor;
};

/// The parts of a plot's frame that are covered, where a legend or label should not be placed.
struct CoveredArea {
    std::vector<std::pair<CanvasPoint, CanvasPoint>> segments;
    std::vector<CanvasBox> boxes;
    /// Lines for reference, which a legend hides rather than values.
    std::vector<std::pair<CanvasPoint, CanvasPoint>> references;

    /// How much of it a box touches, without references.
    [[nodiscard]] int within(const CanvasBox& box) const;
    /// How many references a box touches.
    [[nodiscard]] int references_within(const CanvasBox& box) const;
};

/// One plot in one frame, with everything that must be determined before drawing.
struct PlotDrawing {
    /// `stretch` of PlotAxes.
    PlotDrawing(const Canvas& canvas, const Plot& plot, const CanvasBox& frame, double stretch);

    PlotAxes axes;
    std::vector<PlotLabel> labels;
    std::optional<LegendBox> legend;
    PanelMargins margins;
};

/// With the legend within the frame if the plot leaves that open and there is room for it, or is
/// where the upright axes reach a little further up.
PlotDrawing plot_drawing(const Canvas& canvas, const Plot& plot, const CanvasBox& frame);

/// The series of a plot in their looks: those that are given, else the next of the cycle.
std::vector<SeriesLook> series_looks(const Plot& plot);

/// The curves, bands, markers and bars of a plot, within its frame.
void draw_series(Canvas& canvas, const Plot& plot, const PlotAxes& axes);

/// What the series of a plot cover.
CoveredArea clutter_of_series(const Canvas& canvas, const Plot& plot, const PlotAxes& axes);

/// A legend for a plot; none where no series has a label or the plot wants none. `margins` are
/// those of the axes.
std::optional<LegendBox> place_legend(const Canvas& canvas, const Plot& plot, const PlotAxes& axes,
                                      const PanelMargins& margins, const CoveredArea& clutter);

void draw_legend(Canvas& canvas, const Plot& plot, const LegendBox& legend);

/// Draws a sample of a series, from `at` so far rightward.
void draw_sample(Canvas& canvas, const PlotSeries& series, const SeriesLook& look,
                 const CanvasPoint& at, double length);

/// The size of a series's markers, units.
double marker_size(const Canvas& canvas, const PlotSeries& series);

}  // namespace fumon
