#pragma once

#include <cmath>
#include <cstdint>

#include "base/grid.h"

namespace fumon {

/// Heights and thicknesses as whole numbers of 2⁻³² m. Sums of them are exact in any order, so that
/// sand is conserved to the last unit whatever moves it and in whatever order threads run. As
/// doubles they are exact below 2²¹ m.
using FixedPointGrid = Field<std::int64_t>;

/// Of such a grid, or one of doubles, in a line of the processor's caches.
inline constexpr int cells_of_cache_line = 8;

inline constexpr double units_per_metre = 0x1p32;
inline constexpr double metres_per_unit = 0x1p-32;

inline std::int64_t to_units(double metres) {
    return std::llround(metres * units_per_metre);
}

inline double to_metres(std::int64_t units) {
    return static_cast<double>(units) * metres_per_unit;
}

}  // namespace fumon
