#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/grid.h"
#include "base/image.h"

namespace fumon {

/// How many cells along each side one point of a surface stands for, so that it has at most so many
/// triangles.
int cells_per_point(const Grid& bed, std::size_t most_triangles);

/// Means over k × k cells, those without data left out; where half of the cells or more have none,
/// that of a neighbour to the west or south, or 0.
Field<float> coarse_field(const Grid& field, const Mask& nodata, int cells, double zero,
                          double unit);

/// 1 where half of the k × k cells or more have no data; empty where that is nowhere.
Mask coarse_mask(const Mask& nodata, int nx, int ny, int cells);

/// Gives pixels that are not opaque the colour of the nearest ones that are, and makes the picture
/// opaque.
void fill_beside(Image& image);

/// A side of a cell beyond which there is no other, or none with data.
struct OuterSide {
    int x = 0;
    int y = 0;
    int face = 0;  ///< 0 east, 1 north, 2 west, 3 south
};

std::vector<OuterSide> outer_sides(int nx, int ny, const Mask& nodata);

}  // namespace fumon
