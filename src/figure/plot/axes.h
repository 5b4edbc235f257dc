#pragma once

#include <string>

#include "figure/canvas/canvas.h"
#include "figure/canvas/panel.h"
#include "figure/plot/plot_axes.h"

namespace fumon {

/// What an axis runs over, in the unit that its label states.
struct AxisRange {
    double low = 0.0;
    double high = 1.0;
    std::string label;        ///< the quantity and its unit; may be empty
    bool tick_labels = true;  ///< false: neither they nor the label show
    bool ticks = true;        ///< false: no marks either
};

/// Linear axes of a picture in a frame on a canvas: places and values, and the axes of a plot
/// around it.
class Axes {
  public:
    /// Neither range is empty.
    Axes(const CanvasBox& frame, AxisRange x, AxisRange y);

    [[nodiscard]] const CanvasBox& frame() const { return frame_; }
    [[nodiscard]] const AxisRange& x() const { return x_; }
    [[nodiscard]] const AxisRange& y() const { return y_; }
    /// Where a pair of values lies.
    [[nodiscard]] CanvasPoint at(double x, double y) const;
    /// The values at a place.
    [[nodiscard]] CanvasPoint value(const CanvasPoint& place) const;

    /// The room that ticks and labels take around the frame.
    [[nodiscard]] PanelMargins margins(const Canvas& canvas) const;
    /// The frame, its ticks and their labels, and the labels of both axes.
    void draw(Canvas& canvas) const;

  private:
    [[nodiscard]] PlotAxes drawn(const Canvas& canvas) const;

    CanvasBox frame_;
    AxisRange x_;
    AxisRange y_;
};

/// The outline of a box, `width` units wide.
void outline(Canvas& canvas, const CanvasBox& box, double width);

/// A text of that size, broken at the space that leaves the shorter lines where it is longer than
/// `longest` units.
std::string in_two_lines(const Canvas& canvas, const std::string& text, double longest,
                         double size);

/// Writes a text smaller where it would be longer than `longest` units.
void write_within(Canvas& canvas, const std::string& text, double longest, const CanvasPoint& at,
                  const CanvasPoint& anchor, double size, bool upright = false);

}  // namespace fumon
