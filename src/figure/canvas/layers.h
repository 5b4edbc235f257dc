#pragma once

#include "base/image.h"
#include "figure/canvas/canvas.h"

namespace fumon {

/// Lays a layer over an image, in sRGB, its upper left pixel at (left, top); what lies outside the
/// image is left out. `opacity`: 0 … 1, of the whole layer.
void composite_over(Image& image, const CanvasLayer& layer, int left, int top,
                    double opacity = 1.0);

/// The layer over a soft dark shadow of itself that reaches `radius` pixels: legible without a
/// plate on bright and on dark ground. The shadow stays within the layer.
CanvasLayer with_soft_shadow(const CanvasLayer& layer, int radius);

/// The layer with dark and bright exchanged: black letters become white ones.
CanvasLayer inverted(CanvasLayer layer);

}  // namespace fumon
