#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon::block_vectors {

// A sample of what stands nearest in one number: its nearness, a float above 0, whose lowest bits
// are the kind of what is seen. The larger one is nearer, in whatever order they come.
constexpr std::uint32_t kind_bits = 7;
constexpr std::uint32_t surface_kind = 1;  ///< those above are the block's sides; 0: nothing

/// Corners in the picture: 1/256 of a sample from its lower left, and nearness.
struct Corners {
    std::vector<std::int32_t> x;
    std::vector<std::int32_t> y;
    std::vector<float> nearness;

    void resize(std::size_t count);
};

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
};

/// Sets corners first … first + count − 1 from places (east and north by turns) and heights.
void place_corners(const Placed& placed, const float* places, const float* heights,
                   std::size_t count, Corners& corners, std::size_t first);

/// Samples of some rows of a tile, columns and rows counted over the whole picture.
struct Band {
    std::uint32_t* samples;  ///< rows upward, each `stride` long: `beyond` more than columns
    std::size_t stride;
    int first_column;
    int end_column;
    int first_row;
    int end_row;

    static constexpr std::size_t beyond = 64;
};

/// Triangles, three corners each; counter-clockwise ones look at the eye.
struct Triangles {
    const std::uint32_t* corners;  ///< counted from `first_corner` on
    std::size_t first_corner;
    const std::uint32_t* listed;  ///< which of them, `count` numbers
    std::size_t count;
    std::uint32_t kind;
    bool both_faces;  ///< else backs are left out
};

/// Draws what a band's samples see of triangles. A sample lies in one of two triangles that share
/// an edge, never in both or none: edges are whole numbers.
void draw(const Corners& corners, const Triangles& triangles, const Band& band);

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
