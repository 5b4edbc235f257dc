#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// Which way the crests of a bed run.
struct CrestOrientation {
    /// Of the crests against the normal to the wind, −90 < degrees ≤ 90: 0 where they lie across
    /// the wind, positive where they are turned counterclockwise on the map, ±90 where they run
    /// along it. NaN for a bed without relief.
    double degrees = std::numeric_limits<double>::quiet_NaN();
    /// 1 where every slope lies along one line, 0 where none is preferred (the degrees then mean
    /// nothing): (J1 − J2)/(J1 + J2) of the tensor's principal values.
    double coherence = std::numeric_limits<double>::quiet_NaN();
};

/// From the structure tensor J = Σ ∇h ∇hᵀ over the bed, whose principal direction is the normal of
/// the crests (Bigün & Granlund 1987). Slopes are central differences of fourth order, of equal
/// sites in x and y; they see waves of 8 sites 1 % too flat, of 4 sites 15 %. Where the bed is not
/// periodic the two outermost cells are left out. Steep faces weigh most; two crossing sets of
/// crests give one mean direction and a low coherence. NaN for beds of fewer than 5 × 5 cells.
CrestOrientation crest_orientation(const Grid& bed, bool periodic);

}  // namespace fumon
