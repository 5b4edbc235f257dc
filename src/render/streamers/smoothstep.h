#pragma once

#include <algorithm>

namespace fumon {

/// 0 at `from` … 1 at `to`, which may be the lower one, and beyond; level at both.
inline double smoothstep(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace fumon
