#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/samples/rasteriser_vectors.h"

namespace fumon::block_vectors {

constexpr std::uint32_t surface_kind = 1;  ///< those above are the block's sides; 0: nothing

/// A linear function of a point (0 … 1 east and north over the block) and a height.
struct AffineFunction {
    double east;
    double north;
    double height;
    double constant;
};

/// Where points stand in the picture: x, y and reversed z, all of them over `depth`.
struct VertexProjection {
    AffineFunction x;
    AffineFunction y;
    AffineFunction reversed_z;
    AffineFunction depth;
    double least_depth;
};

/// Sets corners first … first + count − 1 from points (east and north by turns) and heights. Those
/// nearer than least_depth, or farther aside than guard_band, get no place: reversed_z 0.
void project_vertices(const VertexProjection& projection, const float* positions,
                      const float* heights, std::size_t count,
                      rasteriser_vectors::ProjectedVertices& vertices, std::size_t first);

/// How points of a row of samples follow from their reversed z: origin + t · direction, both linear
/// in the column's middle.
struct Rays {
    float origin;
    float origin_by_column;
    float direction;
    float direction_by_column;
};

/// t = numerator / reversed_z, or, without perspective, first + reversed_z · by_reversed_z.
struct Depths {
    bool perspective;
    float numerator;
    float first;
    float by_reversed_z;
};

/// The block's surface: display values and how much of the grain is seen (RGBA, a byte each, red in
/// the lowest), and the grain, as packed_grain() has it.
struct SurfaceTexture {
    const std::uint32_t* texels;
    int width;
    int height;
    const std::uint32_t* grain;  ///< nullptr: none
    float grain_east;            ///< texels over the block
    float grain_north;
    float strength;
};

/// What becomes of a pixel.
enum PixelState : std::uint8_t {
    uncovered = 0,  ///< by none of its samples
    // 2 …: a side's kind, which all of them see
    mixed = 254,        ///< several things
    surface_only = 255  ///< it sees the surface alone
};

/// Pixels whose samples are coloured one by one.
struct EdgePixels {
    static constexpr int samples = 4;  ///< south-west, south-east, north-west, north-east
    std::size_t count = 0;
    std::vector<std::int32_t> pixel;
    std::vector<std::uint32_t> kinds;  ///< a byte each
    std::vector<float> east[samples];
    std::vector<float> north[samples];
    std::vector<std::uint32_t> sums[3];  ///< of squares of bytes, over samples of the surface

    void allocate(int pixels);
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
void shade_row(const PixelRow& row, const SurfaceTexture& surface, const PixelPlanes& planes,
               EdgePixels& edges);

/// The grain with its three mipmaps, one after the other: in each number a texel and those east,
/// north and north-east of it, a byte each.
std::vector<std::uint32_t> packed_grain();

}  // namespace fumon::block_vectors
