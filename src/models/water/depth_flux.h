#pragma once

#include "base/grid.h"

namespace fumon {

/// Depths before a sub-step, m, and the velocities that carry them, m/s: periodic.
struct CarriedDepth {
    const Grid& before;
    const Grid& u;
    const Grid& v;
};

/// Depth that passed faces in a sub-step, m.
struct PassedDepth {
    Grid east;   ///< (nx + 1) × ny: eastward through the face west of cell x
    Grid north;  ///< nx × ny: northward through the face north of cell y
};

/// Where more would leave a cell through its faces (cip::through_faces) than it has: all that
/// leaves it is scaled down alike, so that no water is lost and none is borrowed. Finds all depths
/// `after` the sub-step anew; `per_x` is dt/dx, `fallen` the rain of the sub-step, m. Returns what
/// passed.
PassedDepth share_depth(const CarriedDepth& carried, double per_x, double per_y, double fallen,
                        Grid& after);

}  // namespace fumon
