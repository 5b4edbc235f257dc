#pragma once

#include <optional>

#include "base/grid.h"

namespace fumon {

/// Still water that reaches over a bed's edge and is no sea.
struct EdgeLake {
    Mask edge;     ///< its cells along the edge
    double level;  ///< of its surface
};

/// Of a bed with water: the one that takes most of the edge. Its surface is level there and some
/// cells within, so that a river that runs out is not one. `surface` of the water, which is
/// `water` deep, all of one unit; `speed` m/s; `depth`: how many cells each lies within; 0 outside.
std::optional<EdgeLake> lake_at_edge(const Grid& surface, const Grid& water, const Grid& speed,
                                     const Field<float>& depth, double least_depth,
                                     double tolerance);

}  // namespace fumon
