#pragma once

#include <limits>

#include "base/grid.h"
#include "measure/air/profile_under_air.h"

namespace fumon {

/// The extremes of the air in a section.
struct AirExtremes {
    double largest_speed = 0.0;  ///< of √(u² + w²) over the nodes above the bed, m/s
    /// Largest |∂u/∂x + ∂w/∂z| by central differences, 1/s, over the nodes whose four neighbours
    /// are above the bed too. A projection method makes another, compact divergence vanish, so
    /// this one does not vanish with it: it falls as the grid is refined.
    double largest_divergence = 0.0;
};

AirExtremes air_extremes(const Grid& velocity_x, const Grid& velocity_z, const ProfileUnderAir& bed,
                         double dx, double dz);

/// The extremes of the pressure on the bed, at the first node above it in each column.
struct BedPressureExtremes {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double highest = none;  ///< Pa
    double lowest = none;   ///< Pa
    /// Where, metres downwind of the nearest crest: above 0 over the lee side, below over the stoss
    /// side. NaN over a level bed.
    double highest_from_crest = none;
    double lowest_from_crest = none;
};

BedPressureExtremes bed_pressure(const Grid& pressure, const ProfileUnderAir& bed, double dx);

}  // namespace fumon
