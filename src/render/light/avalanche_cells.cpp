#include "render/light/avalanche_cells.h"

#include <algorithm>
#include <cstddef>

#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr std::uint8_t has_avalanche = 1;
constexpr std::uint8_t is_steep = 2;
constexpr float level = 32767.0F;  // of a normal's x and y
// Of squares of slopes, by which whole numbers and a texture's means may be less than they are.
constexpr float rounding = 0.999F;

/// What each cell of a row is by itself.
void find(const std::uint16_t* texels, const std::uint8_t* surface, int count, float least,
          std::uint8_t* found) {
    for (int x = 0; x < count; ++x) {
        const auto i = static_cast<std::size_t>(x);
        const float east = static_cast<float>(texels[4 * i]) - level;
        const float north = static_cast<float>(texels[4 * i + 1]) - level;
        const int steep = east * east + north * north > least ? is_steep : 0;
        const int slid = surface[2 * i + 1] != 0 ? has_avalanche : 0;
        found[i] = static_cast<std::uint8_t>(steep | slid);
    }
}

/// What a row's cells and those beside them are.
void widen(std::uint8_t* row, int count, std::vector<std::uint8_t>& before) {
    before.assign(row, row + count);
    const auto n = static_cast<std::size_t>(count);
    for (std::size_t x = 1; x + 1 < n; ++x)
        row[x] = static_cast<std::uint8_t>(before[x - 1] | before[x] | before[x + 1]);
    for (const std::size_t x : {std::size_t{0}, n - 1})
        row[x] =
            static_cast<std::uint8_t>(before[(x + n - 1) % n] | before[x] | before[(x + 1) % n]);
}

}  // namespace

AvalancheCells avalanche_cells(const LightTexels& texels, const std::vector<std::uint8_t>& surface,
                               int nx, int ny, float least_slope, WorkerPool& pool) {
    const auto columns = static_cast<std::size_t>(nx);
    const float squared = least_slope * least_slope;
    const float least = rounding * level * level * squared / (1.0F + squared);
    std::vector<std::uint8_t> cells(columns * static_cast<std::size_t>(ny));
    pool.for_ranges(ny, [&](int begin, int end) {
        std::vector<std::uint8_t> before;
        for (int y = begin; y < end; ++y) {
            const std::size_t first = columns * static_cast<std::size_t>(y);
            find(texels.data() + 4 * first, surface.data() + 2 * first, nx, least,
                 cells.data() + first);
            widen(cells.data() + first, nx, before);
        }
    });
    AvalancheCells slid{nx, ny, {}};
    const auto words = static_cast<std::size_t>(slid.words_per_row());
    slid.words.resize(words * static_cast<std::size_t>(ny));
    pool.for_ranges(ny, [&](int begin, int end) {
        std::vector<std::uint8_t> around(32 * words);
        for (int y = begin; y < end; ++y) {
            const auto row = [&](int v) {
                return cells.data() + columns * static_cast<std::size_t>((v + ny) % ny);
            };
            const std::uint8_t* south = row(y - 1);
            const std::uint8_t* own = row(y);
            const std::uint8_t* north = row(y + 1);
            for (std::size_t x = 0; x < columns; ++x)
                around[x] = (south[x] | own[x] | north[x]) == (has_avalanche | is_steep) ? 1 : 0;
            std::uint32_t* out = slid.words.data() + words * static_cast<std::size_t>(y);
            for (std::size_t i = 0; i < words; ++i) {
                std::uint32_t word = 0;
                for (std::size_t bit = 0; bit < 32; ++bit)
                    word |= static_cast<std::uint32_t>(around[32 * i + bit]) << bit;
                out[i] = word;
            }
        }
    });
    return slid;
}

}  // namespace fumon
