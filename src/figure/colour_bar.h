#pragma once

#include <string>

#include "figure/canvas.h"
#include "render/palette.h"

namespace fumon {

/// Which colour stands for which value: linear from `low` to `high`, the end colours beyond them.
struct ColourScale {
    Palette palette{};
    double low = 0.0;
    double high = 1.0;
    std::string label;  ///< the quantity and its unit

    [[nodiscard]] Ink ink(double value) const;
};

/// Draws the bar of a colour scale right of a frame, as high as it, with its ticks and label.
void draw_colour_bar(Canvas& canvas, const CanvasBox& frame, const ColourScale& scale);

/// Font sizes that a colour bar takes to the right of a frame.
constexpr double colour_bar_room = 7.2;

}  // namespace fumon
