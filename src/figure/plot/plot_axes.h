#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "figure/plot/plot_scale.h"

namespace fumon {

/// The axes of a plot around a frame, and the places of values in it.
class PlotAxes {
  public:
    /// Where the plot leaves the high ends of the upright axes open, they lie that share of
    /// `stretch` further up.
    PlotAxes(const Canvas& canvas, const Plot& plot, const CanvasBox& frame, double stretch = 0.0);

    [[nodiscard]] const CanvasBox& frame() const { return frame_; }

    /// The place of a pair of values, left or right axis; far outside the frame it is brought
    /// nearer, since Cairo takes no large numbers.
    [[nodiscard]] CanvasPoint at(double x, double y, bool on_right = false) const;
    /// Whether the axes can show a pair of values at all.
    [[nodiscard]] bool shows(double x, double y, bool on_right = false) const;

    /// The room for ticks and labels.
    [[nodiscard]] PanelMargins margins(const Canvas& canvas) const;
    void draw(Canvas& canvas) const;

  private:
    struct Side {
        PlotScale scale;
        PlotTicks ticks;
        std::string label;
        bool labelled = true;
        double widest = 0.0;  ///< of its tick labels, units
    };

    static Side side(const Canvas& canvas, const PlotAxis& axis, const PlotScale& scale,
                     double length, std::size_t dimension, double apart);
    [[nodiscard]] double room_beside(const Canvas& canvas, const Side& side) const;
    void draw_across(Canvas& canvas) const;
    void draw_upward(Canvas& canvas, const Side& side, bool on_right) const;

    CanvasBox frame_;
    Side x_;
    Side y_;
    std::optional<Side> right_;
};

/// Sizes of texts, of the canvas's font size.
constexpr double tick_text_size_em = 0.85;
constexpr double label_text_size_em = 0.95;

}  // namespace fumon
