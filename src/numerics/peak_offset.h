#pragma once

namespace fumon {

/// Where a parabola through three neighbouring values has its top, measured from the middle one,
/// between −1/2 and 1/2 where the middle one is the highest; 0 where they lie on a line.
inline double peak_offset(double before, double middle, double after) {
    const double curvature = before - 2.0 * middle + after;
    return curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

}  // namespace fumon
