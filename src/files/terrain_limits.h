#pragma once

namespace fumon {

/// Cells: the largest terrain that is read (11,585 × 11,585; 1 GiB as doubles).
inline constexpr long long largest_terrain = 1LL << 27;

}  // namespace fumon
