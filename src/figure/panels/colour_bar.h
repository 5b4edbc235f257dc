#pragma once

#include <string>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/canvas/panel.h"
#include "render/colour/palette.h"

namespace fumon {

/// Which colour stands for which value: linear from `low` to `high`, the end colours beyond them.
struct ColourScale {
    Palette palette{};
    double low = 0.0;
    double high = 1.0;
    std::string label;          ///< the quantity and its unit
    bool values_below = false;  ///< there are some, which a triangle at the bar's end says
    bool values_above = false;
    bool ends_labelled = false;  ///< the bar's two ends have ticks, whatever their values
    /// Names of parts of the palette, all as long as each other, in place of numbers; empty: none.
    std::vector<std::string> classes{};

    /// The place of a value in the palette, 0 … 255.
    [[nodiscard]] std::size_t place(double value) const;
    [[nodiscard]] Ink ink(double value) const;
};

/// How a colour bar lies: upright with its ticks and label to the right, or level with them below.
enum class BarDirection { upright, level };

/// What a colour bar's ticks and label take around the bar itself, of the size of `bar`.
PanelMargins colour_bar_margins(const Canvas& canvas, const CanvasBox& bar,
                                const ColourScale& scale, BarDirection direction);

/// Draws a bar that fills `bar`, its ticks and its label.
void draw_colour_bar(Canvas& canvas, const CanvasBox& bar, const ColourScale& scale,
                     BarDirection direction, const Ink& ink = {});

/// Where the colour bar of a picture stands.
enum class BarPosition { none, right, below };

/// The margins of a frame with the bar of its colours: right of the frame and as high as it, or
/// as wide as it beneath all that stands below it. `margins` are those without the bar.
PanelMargins with_colour_bar(const Canvas& canvas, const PanelMargins& margins, BarPosition place,
                             const ColourScale& scale, double width, double height);

/// Draws that bar.
void draw_placed_bar(Canvas& canvas, const CanvasBox& frame, const PanelMargins& margins,
                     BarPosition place, const ColourScale& scale);

}  // namespace fumon
