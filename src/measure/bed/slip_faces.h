#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// The sides of dunes that lie in the wind shadow of their own crests.
struct SlipFaces {
    double angle = std::numeric_limits<double>::quiet_NaN();  ///< median steepness, degrees
    double cover = 0.0;                                       ///< share of all cells
};

/// Slip faces are the cells in full wind shadow (`shadow` of 0.99 or more, on a scale of 0 to 1)
/// whose centred gradient is 20 degrees or more: shadows on gentler ground are those of dunes
/// upwind. Across the edges gradients go on in a periodic bed; in another, cells at the edge do not
/// count. Bed and cell sizes in the same unit. The median is of the nearest rank; without a slip
/// face there is no angle (NaN).
SlipFaces slip_faces(const Grid& bed, const Grid& shadow, bool periodic, double dx, double dy);

}  // namespace fumon
