#pragma once

#include "base/grid.h"
#include "models/dunes/wind/wind_bend.h"
#include "models/dunes/wind/wind_schedule.h"

namespace fumon {

class Plants;

/// The wind of a step over a bed, and what makes it other than uniform.
struct WindOverBed {
    const BlowingWind& blowing;
    const Grid& shade;            ///< r, 0 … 1: the wind shadow
    const Grid* shear = nullptr;  ///< τ/τ0 − 1, of which the lift's factor is f = 1 + that
    const Plants* plants = nullptr;
    const Grid* sheltered = nullptr;     ///< (u*s/u*)² by plants, which then lift by that
    const Grid* before_walls = nullptr;  ///< u
    const Grid* along_walls = nullptr;   ///< v, with u only
    const BentWind* bent = nullptr;      ///< which way hops go
};

/// The factor of the lift over bare sand is never more: nothing linear holds there.
inline constexpr double greatest_lift = 5.0;

/// f (1 − r) in a cell: what the wind lifts of loose sand, in parts of what it would from flat
/// ground.
double lift_factor(const WindOverBed& wind, int x, int y);

}  // namespace fumon
