#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/grid.h"
#include "render/samples/g_buffer_vectors.h"

namespace fumon {

/// Kinds of pixels that show the surface of a block with water, as 255ths of the depth value that
/// separates their draws. Those that show more have the greater numbers.
enum ShadedKind : std::uint8_t {
    shows_nothing = 0,
    shows_dry_ground = 64,  ///< at most so little water that it closes nowhere
    shows_film = 128,
    shows_any = 192
};

/// What the pixels of a tile show of the surface of a block, to be shaded one by one: rows upward
/// from the tile's lower left, `stride` texels each. Pixels whose samples show two positions
/// have these above the highest pixel that shows something.
struct GBuffer {
    std::size_t stride = 0;
    glm::ivec2 low{0};  ///< of the pixels that show something, and those of two points
    glm::ivec2 size{0};
    std::vector<float> positions;        ///< see g_buffer_vectors::resolve_positions(): 4 a texel
    std::vector<std::uint8_t> kinds;     ///< a ShadedKind a texel
    std::vector<std::uint32_t> colours;  ///< of size.x × size.y texels, RGBA of 8 bits

    void allocate(int width, int rows);
};

/// Rows that a tile has for pixels of two points, beside those of its pixels.
int spare_rows(int tile_height);

/// Of a bed under water that is looked at through its mipmaps, of which three count. Depths in
/// metres; see closed_depth().
g_buffer_vectors::KindMap kind_map(const Field<float>& depth, double closed_depth);

}  // namespace fumon
