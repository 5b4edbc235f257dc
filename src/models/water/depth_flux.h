#pragma once

#include "base/grid.h"

namespace fumon {

/// Depths before a sub-step, m, and the velocities that carry them, m/s: periodic.
struct CarriedDepth {
    const Grid& before;
    const Grid& u;
    const Grid& v;
};

/// Where more would leave a cell through its faces (cip::through_faces) than it has: all that
/// leaves it is scaled down alike, so that no water is lost and none is borrowed. Finds all depths
/// `after` the sub-step anew; `per_x` is dt/dx, `fallen` the rain of the sub-step, m.
void share_depth(const CarriedDepth& carried, double per_x, double per_y, double fallen,
                 Grid& after);

}  // namespace fumon
