#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

/// How long the ring of a drop is seen on water, s.
inline constexpr double ring_lifetime_s = 0.75;

/// Texels along each side of a tile of rings, and its length in metres.
inline constexpr int ring_texels = 512;
inline constexpr double ring_tile_m = 2.0;

/// How many tiles lie over each other, each turned, so that their repetition is not seen.
inline constexpr int ring_layers = 2;

/// The slope that a tile's bytes end at, and the mean square slope.
inline constexpr double max_ring_slope = 0.8;
inline constexpr double max_ring_mean_square_slope = 0.25;

/// Drops whose rings are seen from a few metres, that fall on a square metre in a second, in a
/// rain of so many millimetres an hour: 3.3 for each of these, up to 200 mm/h. So many are wider
/// than 3 mm by the sizes of Marshall & Palmer (1948), N = 8000 exp(−4.1 R^−0.21 D) per m³ and mm,
/// at the speeds of Atlas & Ulbrich (1977), 3.78 D^0.67 m/s: computed, 2.6 to 4.3 for each
/// millimetre an hour between 25 and 100 of them.
double ring_drop_rate(double rate);

/// A drop that has fallen on a tile.
struct FallenDrop {
    double x;  ///< m, from 0 to ring_tile_m
    double y;
    double age;   ///< s, below ring_lifetime_s
    double size;  ///< of its ring, in parts of the usual
};

/// Those on one tile whose rings are seen at a time, s. Drops of any second are the same whatever
/// the time that they are looked at, so that rings grow from frame to frame.
std::vector<FallenDrop> fallen_drops(double time, double rate);

/// The rings on a tile that repeats, four bytes a texel: the slopes of the surface east and north,
/// around 127.5 of max_ring_slope each, its mean square slope in parts of
/// max_ring_mean_square_slope, and 255. Then the same of half as many texels along each side, each
/// the mean of four, down to one.
std::vector<std::vector<std::uint8_t>> ring_tile_levels(double time, double rate);

}  // namespace fumon
