#include "render/samples/g_buffer.h"

#include <algorithm>
#include <cmath>

#include "render/samples/rasteriser_vectors.h"

namespace fumon {

namespace {

// See shaders/bed/water.glsl.
constexpr double dry_share = 0.21;
constexpr double film_share = 3.0;
constexpr float over_samples = 1.2F;  // of level_over() in shaders/water/water_visibility.glsl

/// For each of `to` cells along an axis the first and the last of `from` finer ones that a look
/// between it and its neighbours may meet.
std::vector<glm::ivec2> met_along(int from, int to) {
    std::vector<glm::ivec2> met;
    for (int i = 0; i < to; ++i) {
        const int first = std::max(i - 1, 0) * from / to;
        const int last = (std::min(i + 2, to) * from + to - 1) / to - 1;
        met.emplace_back(first, std::min(last, from - 1));
    }
    return met;
}

}  // namespace

void GBuffer::allocate(int width, int rows) {
    stride = static_cast<std::size_t>(width) + rasteriser_vectors::Band::beyond;
    const std::size_t texels = stride * static_cast<std::size_t>(rows);
    positions.resize(4 * texels);
    kinds.resize(texels);
}

int spare_rows(int tile_height) {
    return tile_height / 3 + 4;
}

g_buffer_vectors::KindMap kind_map(const Field<float>& depth, double closed_depth) {
    Field<std::uint8_t> finest(depth.nx(), depth.ny());
    const auto dry = static_cast<float>(dry_share * closed_depth);
    const auto film = static_cast<float>(film_share * closed_depth);
    std::ranges::transform(depth.values(), finest.values().begin(), [&](float metres) {
        return metres < dry ? shows_dry_ground : metres < film ? shows_film : shows_any;
    });
    g_buffer_vectors::KindMap map;
    constexpr int first = 1;
    constexpr int last = 3;
    for (int level = first; level <= last; ++level) {
        const int nx = std::max(depth.nx() >> level, 1);
        const int ny = std::max(depth.ny() >> level, 1);
        map.levels.push_back({static_cast<int>(map.kinds.size()), nx, ny});
        if (level > first)
            map.bounds[map.levels.size() - 2] =
                std::sqrt(static_cast<float>(1 << (2 * level - 1))) / over_samples;
        const std::vector<glm::ivec2> columns = met_along(depth.nx(), nx);
        const std::vector<glm::ivec2> rows = met_along(depth.ny(), ny);
        Field<std::uint8_t> along(nx, depth.ny());
        for (int y = 0; y < depth.ny(); ++y) {
            const auto row = finest.row(y).begin();
            for (int x = 0; x < nx; ++x) {
                const glm::ivec2 met = columns[static_cast<std::size_t>(x)];
                along(x, y) = *std::max_element(row + met.x, row + met.y + 1);
            }
        }
        for (const glm::ivec2& met : rows) {
            const std::size_t from = map.kinds.size();
            map.kinds.resize(from + static_cast<std::size_t>(nx), shows_nothing);
            const auto out = map.kinds.begin() + static_cast<std::ptrdiff_t>(from);
            for (int y = met.x; y <= met.y; ++y)
                std::transform(out, map.kinds.end(), along.row(y).begin(), out,
                               [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
        }
    }
    map.kinds.resize(map.kinds.size() + 3, shows_nothing);  // a look takes four bytes
    return map;
}

}  // namespace fumon
