#pragma once

#include <span>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/canvas/furniture.h"
#include "figure/layers/seen_layers.h"

namespace fumon {

/// How layers stand on a canvas.
struct LayerStyle {
    double pixel = 1.0;  ///< of widths and dashes, in the canvas's units
    /// Labels have one place each, and fade where another comes near: frames of a moving camera.
    bool moves = false;
};

/// A pixel of layers on a page, points: 1/96 inch.
inline constexpr double page_pixel = 0.75;

/// Strokes layers within a frame, the first lowest, and writes their labels over all of them, those
/// of earlier features and layers first; they keep away from one another and from `taken`.
void draw_layers(Canvas& canvas, const CanvasBox& frame, std::span<const LayerSettings> settings,
                 const std::vector<SeenLayer>& layers, const std::vector<CanvasBox>& taken,
                 const LayerStyle& style);

/// Whether a layer has an entry in legends.
bool has_legend(std::span<const LayerSettings> settings);

/// The size of a legend of layers: a sign and what it shows, each in a line.
FurnitureSize layer_legend_size(const Canvas& canvas, std::span<const LayerSettings> settings);

/// Draws one with its upper left corner at a point; signs are those of what a layer has: areas,
/// else lines, else points.
void draw_layer_legend(Canvas& canvas, const CanvasPoint& corner,
                       std::span<const LayerSettings> settings, const PlacedLayers& placed,
                       double pixel);

}  // namespace fumon
