#pragma once

#include <array>
#include <memory>
#include <span>

#include "drape/placed_drape.h"
#include "scene/view/layers.h"

namespace fumon {

/// Areas of an even colour.
struct FilledAreas {
    const PlacedLayer* layer = nullptr;
    std::array<double, 3> colour{};  ///< sRGB, 0 … 1
    double opacity = 1.0;
};

/// A drape with areas over it, those that come later above others; edges are even shares of
/// pixels. `under`, seen with its strength 0 … 1, may be null: the areas then have four pixels to
/// each side of a cell, as far as `most_drape_pixels` allow. Null where there are no areas.
std::shared_ptr<const Drape> with_areas(const std::shared_ptr<const Drape>& under, double strength,
                                        std::span<const FilledAreas> areas, const BedCells& bed);

}  // namespace fumon
