#pragma once

/// What TileWarp changes, and how far; as shaders/world/tile_warp.glsl.
namespace fumon::tile_warp {

/// A wave over the ground.
struct Wave {
    double east;  ///< of its lengths to a period of the bed
    double north;
    double begin;       ///< likewise, in the middle
    double aside_east;  ///< how far aside ground is taken from at its crests, periods
    double aside_north;
    double lower;  ///< by how much ground is lowered, a quarter of its length before them
};

inline constexpr double unwarped_radius_periods = 0.7;  ///< periods around the middle
/// Over how many periods more the waves, and how high ground stands, come up.
inline constexpr double short_range = 1.0;
inline constexpr double long_range = 4.0;
inline constexpr double height_range = 0.4;

/// Along themselves, nearly: neighbours are wider or narrower than the bed.
inline constexpr Wave short_waves[] = {
    {0.149, 0.350, 0.13, 0.031, 0.074, 0.10},
    {0.335, -0.065, 0.57, 0.088, -0.017, 0.10},
    {0.257, -0.482, 0.31, 0.040, -0.033, 0.09},
};
/// Across: rows wander.
inline constexpr Wave long_waves[] = {
    {0.097, 0.034, 0.21, 0.081, -0.236, 0.0},
    {-0.028, 0.070, 0.77, 0.287, 0.116, 0.0},
};
/// At most: how far aside ground is taken from, periods, and how much wider than the bed it is.
inline constexpr double largest_offset = 0.7;
inline constexpr double largest_stretch = 2.6;
inline constexpr double lowered = 0.33;  ///< of the bed's height, in the mean

}  // namespace fumon::tile_warp
