#pragma once

#include <vector>

#include "measure/network/flow_routing.h"

namespace fumon {

/// A way down over the cells of a grid: the centre of each and how far it is along the way.
struct StreamPath {
    std::vector<int> x;
    std::vector<int> y;
    std::vector<double> distance;  ///< between centres, in the unit of dx and dy
};

/// The way that water takes from a cell to an outlet. No cell comes twice. Throws InputError where
/// the cell lies outside the grid or has no data.
StreamPath stream_path(const FlowRouting& routing, const Mask& nodata, int x, int y);

/// The cell at which the longest way down begins: the head of the main stream, on the divide.
/// `FlowRouting::outlet` where no cell has data.
std::int32_t main_stream_head(const FlowRouting& routing);

/// How far it is from each cell up to the divide, along the longest way down to it (the cell's own
/// half widths are left out: 0 at a cell into which nothing drains).
Grid longest_path_lengths(const FlowRouting& routing);

}  // namespace fumon
