#pragma once

#include <limits>
#include <span>

#include "measure/air/profile_under_air.h"

namespace fumon {

/// How far the bed's shear stress runs ahead of the bed.
struct StressLead {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double degrees = none;    ///< of the fitted stress before the bed's wave, upwind positive
    double length = none;     ///< the same along x, metres
    double r_squared = none;  ///< of the stress's fit
    double maximum_from_crest =
        none;  ///< x of the largest stress, downwind of the nearest crest, m
};

/// Of a stress curve over the section's columns: its fit (fit_stress) with as many waves as the bed
/// has, beside the bed's own phase, in (−180°, 180°]; and the curve's highest value, refined by a
/// parabola. NaN over a level bed.
StressLead stress_lead(std::span<const double> stress, const ProfileUnderAir& bed, double dx);

}  // namespace fumon
