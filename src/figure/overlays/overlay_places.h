#pragma once

#include <span>
#include <vector>

#include "figure/canvas/furniture.h"
#include "scene/scene.h"

namespace fumon {

/// One thing to place in a picture.
struct OverlayPiece {
    OverlayCorner corner = OverlayCorner::upper_left;
    FurnitureSize size;  ///< pixels
};

/// The boxes of pieces in a picture, whole pixels: those of a corner below one another, `gap`
/// pixels apart and from the edges.
std::vector<CanvasBox> stacked_boxes(std::span<const OverlayPiece> pieces, double width,
                                     double height, double gap);

/// The first piece that leaves the picture or overlaps one before it; their count where none does.
std::size_t first_misfit(std::span<const CanvasBox> boxes, double width, double height);

}  // namespace fumon
