#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/samples/triangle_vectors.h"

namespace fumon::block_vectors {

constexpr std::uint32_t surface_kind = 1;  ///< those above are the block's sides; 0: nothing

/// A linear function of a place (0 … 1 east and north over the block) and a height.
struct Linear {
    double east;
    double north;
    double height;
    double constant;
};

/// Where points stand in the picture: x, y and nearness, all of them over `depth`.
struct Placed {
    Linear x;
    Linear y;
    Linear nearness;
    Linear depth;
    double least_depth;
};

/// Sets corners first … first + count − 1 from places (east and north by turns) and heights. Those
/// nearer than least_depth, or farther aside than farthest_place, get no place: nearness 0.
void place_corners(const Placed& placed, const float* places, const float* heights,
                   std::size_t count, triangle_vectors::Corners& corners, std::size_t first);

/// How places of a row of samples follow from their nearness: origin + t · direction, both linear
/// in the column's middle.
struct Rays {
    float origin;
    float origin_by_column;
    float direction;
    float direction_by_column;
};

/// t = numerator / nearness, or, without perspective, first + nearness · by_nearness.
struct Depths {
    bool perspective;
    float numerator;
    float first;
    float by_nearness;
};

/// The block's surface: display values and how much of the grain is seen (RGBA, a byte each, red in
/// the lowest), and the grain, as packed_grain() has it.
struct Surface {
    const std::uint32_t* texels;
    int width;
    int height;
    const std::uint32_t* grain;  ///< nullptr: none
    float grain_east;            ///< texels over the block
    float grain_north;
    float strength;
};

/// What becomes of a pixel.
enum Pixel : std::uint8_t {
    nothing_seen = 0,  ///< by none of its samples
    // 2 …: a side's kind, which all of them see
    mixed = 254,    ///< several things
    finished = 255  ///< it sees the surface alone
};

/// Pixels whose samples are coloured one by one.
struct Edges {
    static constexpr int samples = 4;  ///< south-west, south-east, north-west, north-east
    std::size_t count = 0;
    std::vector<std::int32_t> pixel;
    std::vector<std::uint32_t> kinds;  ///< a byte each
    std::vector<float> east[samples];
    std::vector<float> north[samples];
    std::vector<std::uint32_t> sums[3];  ///< of squares of bytes, over samples of the surface

    void make_room(int pixels);
};

struct PixelRow {
    const std::uint32_t* lower;  ///< two rows of samples
    const std::uint32_t* upper;
    int first_column;  ///< in the picture
    int pixels;
    Rays east[2];  ///< of either row
    Rays north[2];
    Depths depths;
};

/// Planes of a row, as long as pixels and `Band::beyond`.
struct PixelPlanes {
    std::uint8_t* red;
    std::uint8_t* green;
    std::uint8_t* blue;
    std::uint8_t* state;  ///< a Pixel each
};

/// Colours the pixels whose samples see the surface close together by one look halfway between
/// them, and lists those that see it otherwise, as edges, whose sums it finds.
void colour_row(const PixelRow& row, const Surface& surface, const PixelPlanes& planes,
                Edges& edges);

/// The grain with its three mipmaps, one after the other: in each number a texel and those east,
/// north and north-east of it, a byte each.
std::vector<std::uint32_t> packed_grain();

}  // namespace fumon::block_vectors
