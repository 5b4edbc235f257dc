#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/light/light_texels.h"

namespace fumon {

class WorkerPool;

/// Cells of the maps of endless ground where tongues of avalanches may be seen: in or beside which
/// some sand lies as it slid, and some ground is as steep as it slides on. A bit each, in words of
/// 32 cells, the first one lowest; rows begin with a word.
struct AvalancheCells {
    int nx = 0;
    int ny = 0;
    std::vector<std::uint32_t> words;

    [[nodiscard]] int words_per_row() const { return (nx + 31) / 32; }
    [[nodiscard]] bool at(int x, int y) const {
        const auto row = static_cast<std::size_t>(words_per_row()) * static_cast<std::size_t>(y);
        const std::uint32_t word = words[row + static_cast<std::size_t>(x / 32)];
        return (word >> static_cast<unsigned>(x % 32) & 1U) != 0;
    }
};

/// Slope of sand that begins to slide, heights without exaggeration: tongues are on steeper one.
inline constexpr float min_avalanche_slope = 0.42F;

/// From RepeatedLight's texels and surface, of nx × ny cells that repeat; `least_slope`: of ground
/// as it is drawn. "Beside" takes in the eight neighbours, so that a point between the middles of
/// four cells has in its nearest one all that is known of these four.
AvalancheCells avalanche_cells(const LightTexels& texels, const std::vector<std::uint8_t>& surface,
                               int nx, int ny, float least_slope, WorkerPool& pool);

}  // namespace fumon
