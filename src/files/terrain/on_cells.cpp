#include "files/terrain/on_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "files/terrain/reproject.h"

namespace fumon {

namespace {

/// A place between the middles of cells of a row or column.
struct Between {
    int cell = 0;  ///< in which it lies
    int low = 0;   ///< of the two whose middles are nearest
    int high = 0;
    double share = 0.0;  ///< of the higher one
    bool outside = false;
};

/// `place` in cells from the first one's edge.
Between between(double place, int count) {
    constexpr double rounding = 1e-6;  // of a cell
    Between found;
    found.outside = place < -0.5 || place > count + 0.5;
    found.cell = std::clamp(static_cast<int>(std::floor(place)), 0, count - 1);
    double middle = std::clamp(place - 0.5, 0.0, static_cast<double>(count - 1));
    if (std::fabs(middle - std::round(middle)) < rounding) middle = std::round(middle);
    found.low = static_cast<int>(std::floor(middle));
    found.high = std::min(found.low + 1, count - 1);
    found.share = middle - found.low;
    return found;
}

bool has_data(const Terrain& map, int x, int y) {
    return map.nodata.empty() || map.nodata(x, y) == 0;
}

/// The mean of four cells by their shares, without those that have no data.
double mean_of(const Terrain& map, const Between& x, const Between& y) {
    double sum = 0.0;
    double weight = 0.0;
    const auto add = [&](int at_x, int at_y, double share) {
        if (share == 0.0 || !has_data(map, at_x, at_y)) return;
        sum += share * map.heights(at_x, at_y);
        weight += share;
    };
    add(x.low, y.low, (1.0 - x.share) * (1.0 - y.share));
    add(x.high, y.low, x.share * (1.0 - y.share));
    add(x.low, y.high, (1.0 - x.share) * y.share);
    add(x.high, y.high, x.share * y.share);
    return weight > 0.0 ? sum / weight : 0.0;
}

Terrain by_place(const Terrain& map, const CellLattice& lattice) {
    const GeoReference& from = *map.place;
    const GeoReference& to = *lattice.place;
    Terrain result;
    result.heights = Grid(lattice.nx, lattice.ny);
    for (int y = 0; y < lattice.ny; ++y) {
        const double north = to.south + (y + 0.5) * to.dy;
        const Between row = between((north - from.south) / from.dy, map.heights.ny());
        for (int x = 0; x < lattice.nx; ++x) {
            const double east = to.west + (x + 0.5) * to.dx;
            const Between column = between((east - from.west) / from.dx, map.heights.nx());
            if (!row.outside && !column.outside && has_data(map, column.cell, row.cell)) {
                result.heights(x, y) = mean_of(map, column, row);
                continue;
            }
            if (result.nodata.empty()) result.nodata = Mask(lattice.nx, lattice.ny);
            result.nodata(x, y) = 1;
        }
    }
    return result;
}

/// Whether a grid says where on the Earth it lies: local ones begin at (0, 0).
bool lies_somewhere(const std::optional<GeoReference>& place) {
    return place &&
           (place->west != 0.0 || place->south != 0.0 || place->degrees || !place->crs.empty());
}

}  // namespace

Terrain on_cells(const Terrain& map, const CellLattice& lattice) {
    if (!lies_somewhere(map.place) || !lies_somewhere(lattice.place)) {
        if (map.heights.nx() == lattice.nx && map.heights.ny() == lattice.ny) return map;
        throw InputError(
            fmt::format("has {} x {} cells, but the bed has {} x {}; give it the same size, or "
                        "give both files coordinates",
                        map.heights.nx(), map.heights.ny(), lattice.nx, lattice.ny));
    }
    const GeoReference& from = *map.place;
    const GeoReference& to = *lattice.place;
    const bool named = !from.crs.empty() || from.degrees;
    if (named && !to.crs.empty() && !to.degrees && from.crs != to.crs)
        return by_place(reprojected(map, to.crs), lattice);
    if (from.degrees != to.degrees && named) {
        throw InputError(
            fmt::format("has coordinates in {}, but the bed has them in {}; reproject one of them",
                        from.degrees ? "degrees" : "metres", to.degrees ? "degrees" : "metres"));
    }
    return by_place(map, lattice);
}

}  // namespace fumon
