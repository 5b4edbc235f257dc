#pragma once

#include <cmath>
#include <limits>

namespace fumon::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far a value lies from the true one, in units in the last place of the true one (below it,
/// which is half of that above at powers of two).
inline double ulps_off(double value, long double truth) {
    const auto rounded = static_cast<double>(truth);
    if (value == rounded) return 0.0;
    const double below = std::nextafter(std::fabs(rounded), 0.0);
    const double unit =
        rounded == 0.0 ? std::numeric_limits<double>::denorm_min() : std::fabs(rounded) - below;
    return static_cast<double>(std::fabs(static_cast<long double>(value) - truth)) / unit;
}

}  // namespace fumon::test
