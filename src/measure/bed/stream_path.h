#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// A way down over the cells of a grid: the centre of each and how far it is along the way.
struct StreamPath {
    std::vector<int> x;
    std::vector<int> y;
    std::vector<double> distance;  ///< between centres, in the unit of dx and dy
};

/// The way that water takes from a cell to the edge of the grid, or to cells without data, over
/// `level` (bed or water surface): each time to the steepest lower one of the eight neighbours on
/// the surface whose hollows are filled to their brim, and within a hollow along the way by which
/// the filling found it (priority flood; Barnes, Lehman & Mulla 2014). It always arrives: no cell
/// comes twice. Throws InputError where the cell lies outside the grid or has no data.
StreamPath stream_path(const Grid& level, const Mask& nodata, double dx, double dy, int x, int y);

}  // namespace fumon
