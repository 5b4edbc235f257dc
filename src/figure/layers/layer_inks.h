#pragma once

#include "figure/canvas/canvas.h"
#include "scene/view/layers.h"

namespace fumon {

/// Of a layer's lines and markers.
Ink line_ink(const LayerSettings& settings);

/// Of its areas.
Ink area_ink(const LayerSettings& settings);

/// Draws one of its markers with a pale rim; `pixel` in the canvas's units.
void draw_layer_marker(Canvas& canvas, const LayerSettings& settings, const CanvasPoint& at,
                       double pixel, double opacity);

}  // namespace fumon
