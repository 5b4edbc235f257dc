#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace fumon {

/// Sums of a picture's levels over columns × rows boxes of equal size that tile it, in units of a
/// (columns·rows)-th of a pixel, so that they are exact where a box's edge runs through a pixel.
/// All boxes cover `area` of these units: a sum over `area` is the box's mean level.
struct BoxSums {
    std::uint64_t area = 0;
    std::vector<std::uint64_t> sums;  ///< red, green, blue of each box, top row first
};

/// Boxes may be smaller than pixels. The picture has at least one pixel.
BoxSums box_sums(const Image& image, int columns, int rows);

}  // namespace fumon
