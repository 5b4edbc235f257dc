#pragma once

namespace fumon {

inline constexpr double water_density = 1000.0;  // kg/m³

}  // namespace fumon
