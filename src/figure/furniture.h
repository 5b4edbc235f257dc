#pragma once

#include "figure/canvas.h"

namespace fumon {

/// Where a piece of furniture (a scale bar, a wind arrow …) stands within a picture.
enum class Corner { top_left, top_right, bottom_left, bottom_right };

/// Width and height of a piece of furniture, in the canvas's units.
struct FurnitureSize {
    double width = 0.0;
    double height = 0.0;
};

/// The box of a piece of that size in a corner of `frame`, `margin` units away from both edges.
inline CanvasBox corner_box(const CanvasBox& frame, Corner corner, const FurnitureSize& size,
                            double margin) {
    const bool right = corner == Corner::top_right || corner == Corner::bottom_right;
    const bool bottom = corner == Corner::bottom_left || corner == Corner::bottom_right;
    return {right ? frame.x + frame.width - margin - size.width : frame.x + margin,
            bottom ? frame.y + frame.height - margin - size.height : frame.y + margin, size.width,
            size.height};
}

/// A pale ground that keeps furniture legible over a picture: `box` and a little around it.
inline void draw_plate(Canvas& canvas, const CanvasBox& box,
                       const Ink& ink = {1.0, 1.0, 1.0, 0.8}) {
    const double room = 0.35 * canvas.font_size();
    canvas.fill(
        CanvasBox{box.x - room, box.y - room, box.width + 2.0 * room, box.height + 2.0 * room},
        ink);
}

}  // namespace fumon
