#pragma once

#include <cstdint>

namespace fumon {

// Sizes that fumon accepts, stated once.
inline constexpr double largest_grid_side = 4194304;           // cells; a profile may be that long
inline constexpr std::int64_t largest_grid_cells = 1LL << 27;  // 1 GiB per field: 11,585 × 11,585
inline constexpr double largest_step = 1e15;                   // whole and exact in a double
inline constexpr double smallest_picture_side = 16;            // pixels
inline constexpr double largest_picture_side = 16384;          // pixels

}  // namespace fumon
