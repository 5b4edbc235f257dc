#include "render/light/tiled_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fumon {

namespace {

constexpr double margin_share = 0.25;  // of a tile's longer side, from which light is kept off
// Shares of a tile's side: the plain's light alone, and nothing of it.
constexpr double plain_alone = 0.035;
constexpr double bed_alone = 0.11;

Field<float> tile_of(const Field<float>& maps, int first) {
    Field<float> tile(maps.nx() / 2, maps.ny());
    for (int y = 0; y < tile.ny(); ++y)
        std::copy_n(maps.row(y).begin() + first, tile.nx(), tile.row(y).begin());
    return tile;
}

/// The bed's tile among its neighbours.
Field<float> with_neighbours(const Field<float>& maps, int margin) {
    const int nx = maps.nx() / 2;
    const int ny = maps.ny();
    Field<float> wide(nx + 2 * margin, ny + 2 * margin);
    for (int v = 0; v < wide.ny(); ++v) {
        const int y = v - margin;
        const bool own_y = y >= 0 && y < ny;
        const auto from = maps.row((y % ny + ny) % ny);
        const auto to = wide.row(v);
        for (int u = 0; u < wide.nx();) {
            const int x = u - margin;
            const int first = (x % nx + nx) % nx;
            const int count = std::min(nx - first, wide.nx() - u);
            const bool own = own_y && x >= 0 && x < nx;
            std::copy_n(from.begin() + first + (own ? 0 : nx), count, to.begin() + u);
            u += count;
        }
    }
    return wide;
}

/// How far the plain alone lights a line of cells across a tile.
float plain_share(int cell, int count) {
    const double from_edge = (std::min(cell, count - 1 - cell) + 0.5) / count;
    const double t = std::clamp((bed_alone - from_edge) / (bed_alone - plain_alone), 0.0, 1.0);
    return static_cast<float>(t * t * (3.0 - 2.0 * t));
}

}  // namespace

Field<float> shares_over_tiles(
    const Field<float>& heights, const GroundTiles& tiles,
    const std::function<Field<float>(const Field<float>&)>& repeated,
    const std::function<Field<float>(const Field<float>&, int margin)>& open) {
    if (!tiles.plain) return repeated(heights);
    const int nx = heights.nx() / 2;
    const int ny = heights.ny();
    const Field<float> plain = repeated(tile_of(heights, nx));
    const int margin = static_cast<int>(margin_share * std::max(nx, ny));
    const Field<float> own = open(with_neighbours(heights, margin), margin);
    Field<float> maps(2 * nx, ny);
    std::vector<float> along(static_cast<std::size_t>(nx));
    for (int x = 0; x < nx; ++x) along[static_cast<std::size_t>(x)] = plain_share(x, nx);
    for (int y = 0; y < ny; ++y) {
        const float across = plain_share(y, ny);
        std::copy_n(plain.row(y).begin(), nx, maps.row(y).begin() + nx);
        for (int x = 0; x < nx; ++x) {
            const float share = std::max(along[static_cast<std::size_t>(x)], across);
            maps(x, y) = share > 0.0F ? std::lerp(own(x, y), plain(x, y), share) : own(x, y);
        }
    }
    return maps;
}

}  // namespace fumon
