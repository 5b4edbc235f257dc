#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/samples/block_vectors.h"

namespace fumon::g_buffer_vectors {

/// Kinds of what a pixel may show, over the cells of a bed and their mipmaps: in each cell the
/// highest of those that a look between it and its neighbours may meet.
struct KindMap {
    struct Level {
        int first;  ///< its first cell
        int width;
        int height;
    };
    std::vector<std::uint8_t> kinds;  ///< 3 more than there are cells
    std::vector<Level> levels;        ///< at most 4, finest first
    /// Cells of the bed to a pixel from which each level but the first is used.
    std::array<float, 3> bounds{};
};

/// Rules by which pixels of one surface are separated from pixels of two.
struct SplitRules {
    const KindMap* map;
    glm::vec2 cells;    ///< of the bed, eastward and northward
    glm::vec3 low;      ///< the corner 0, 0, 0 of the block, from the eye
    glm::vec3 size;     ///< from there to the corner 1, 1, 1
    float pixel_width;  ///< at distance 1, or anywhere without perspective
    bool perspective;
    // Samples show two surface positions if these lie farther apart than both limits.
    float split_distance_cells;
    float split_distance_pixels;
};

/// A row of pixels, and how heights follow; see block_vectors.
struct Row {
    block_vectors::PixelRow pixels;
    block_vectors::Rays height[2];
};

/// Pixels that show several things, or two positions of the surface.
struct MultiSurfacePixels {
    static constexpr int samples = block_vectors::EdgePixels::samples;
    std::size_t count = 0;
    std::vector<std::int32_t> pixel;
    std::vector<std::uint32_t> kinds;      ///< of the samples' surfaces, a byte each
    std::vector<std::uint32_t> are_apart;  ///< 1: two positions, else 0
    std::vector<float> positions[3][samples];

    void allocate(int pixels);
};

/// For each pixel the point of its surface, 0 … 1 over the block, that it is shaded for and how
/// many cells its samples lie apart, 4 numbers; of which kind it is (0: it sees no surface); and a
/// block_vectors::Pixel. Rows are longer than pixels by Band::beyond.
void resolve_positions(const Row& row, const SplitRules& rules, float* positions,
                       std::uint8_t* kinds, std::uint8_t* state, MultiSurfacePixels& listed);

}  // namespace fumon::g_buffer_vectors
