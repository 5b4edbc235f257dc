#pragma once

#include "base/grid.h"
#include "measure/air/profile_under_air.h"

namespace fumon {

/// Air that flows back upwind behind a crest.
struct Eddy {
    double length = 0.0;  ///< along x, metres; 0 where no air flows back
    double height = 0.0;  ///< of the highest node that flows back above its bed, metres; 0 likewise
};

/// Of the longest run of neighbouring columns, round the edge, in which some node above the bed
/// flows back: velocity_x below −1e-9 of the largest speed along x, so that rounding is no eddy.
/// The length is the run's number of columns times dx.
Eddy largest_eddy(const Grid& velocity_x, const ProfileUnderAir& bed, double dx, double dz);

}  // namespace fumon
