#pragma once

#include <numbers>

namespace fumon {

inline constexpr double degree = std::numbers::pi / 180.0;  ///< radians
inline constexpr double degrees_per_radian = 57.29577951308232;
inline constexpr double metres_per_millimetre = 1e-3;

}  // namespace fumon
