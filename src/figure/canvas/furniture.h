#pragma once

#include "figure/canvas/canvas.h"
#include "figure/canvas/corner.h"

namespace fumon {

/// Width and height of a piece of furniture (a scale bar, a wind arrow …), in the canvas's units.
struct FurnitureSize {
    double width = 0.0;
    double height = 0.0;
};

/// The box of a piece of that size in a corner of `frame`, `margin` units away from both edges.
inline CanvasBox corner_box(const CanvasBox& frame, Corner corner, const FurnitureSize& size,
                            double margin) {
    const bool right = corner == Corner::upper_right || corner == Corner::lower_right;
    const bool lower = corner == Corner::lower_left || corner == Corner::lower_right;
    return {right ? frame.x + frame.width - margin - size.width : frame.x + margin,
            lower ? frame.y + frame.height - margin - size.height : frame.y + margin, size.width,
            size.height};
}

/// A pale background, a little larger than `box`, that keeps text and bars legible over a picture.
inline void draw_plate(Canvas& canvas, const CanvasBox& box,
                       const Ink& ink = {1.0, 1.0, 1.0, 0.8}) {
    canvas.fill(grown(box, 0.35 * canvas.font_size()), ink);
}

}  // namespace fumon
