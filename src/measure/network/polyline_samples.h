#pragma once

#include <array>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// A place on a line over a grid.
struct PolylinePoint {
    double distance = 0.0;  ///< from where the line begins, in the unit of dx and dy
    double x = 0.0;         ///< cells from the grid's western edge
    double y = 0.0;         ///< cells from its southern edge
};

/// The places of a line through some corners (x, y in cells): both ends, every corner, and between
/// two of them evenly, half a cell (the shorter side of dx × dy) or less apart. At least two
/// corners, no two of which that follow one another are the same.
std::vector<PolylinePoint> sample_polyline(const std::vector<std::array<double, 2>>& corners,
                                           double dx, double dy);

/// A grid's value at a place (in cells, as above), linear between the centres of the four nearest
/// cells and level beyond the outermost ones. Where one of the four has no data it is that of the
/// cell that the place lies in, and NaN where this one has none.
double value_between(const Grid& values, const Mask& nodata, double x, double y);

}  // namespace fumon
