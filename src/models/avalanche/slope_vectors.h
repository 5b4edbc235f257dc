#pragma once

#include <cstdint>

/// The search for steep cells as a loop over vectors.
namespace fumon::slope_vectors {

/// Sets bit x of `bits` where the one-sided slope of cell x of the row `here` exceeds a limit:
///
///     (max(h − h_west, h − h_east, 0)² wx + max(h − h_south, h − h_north, 0)² wy) > limit
///
/// for 1 ≤ x < count − 1, and clears all others; `bits` has (count + 63) / 64 words. Heights are
/// whole numbers below 2⁵².
void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits);

}  // namespace fumon::slope_vectors
