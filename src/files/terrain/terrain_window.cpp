#include "files/terrain/terrain_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "files/terrain/terrain_file.h"

namespace fumon {

namespace {

/// The first of the cells along one side whose centre is not before an edge.
double first_from(double edge, double origin, double cell) {
    // An edge that is meant to lie on one between cells may stand a rounding error beside it.
    constexpr double rounding = 1e-6;  // cells
    return std::ceil((edge - origin) / cell - 0.5 - rounding);
}

[[noreturn]] void refuse_window(const TerrainWindow& window, const GeoReference& grid, int nx,
                                int ny, const char* unit, const std::string& file,
                                const char* what) {
    throw InputError(fmt::format(
        "{}: bed.window [{}, {}, {}, {}] {}; west, south, east and north of the file are [{}, {}, "
        "{}, {}]{}",
        file, window.west, window.south, window.east, window.north, what, grid.west, grid.south,
        grid.west + grid.dx * nx, grid.south + grid.dy * ny, unit));
}

template <class Number>
Field<Number> cut(const Field<Number>& field, const CellBlock& block) {
    Field<Number> part(block.nx, block.ny);
    for (int y = 0; y < block.ny; ++y) {
        const auto from =
            field.row(block.y + y)
                .subspan(static_cast<std::size_t>(block.x), static_cast<std::size_t>(block.nx));
        std::ranges::copy(from, part.row(y).begin());
    }
    return part;
}

}  // namespace

CellBlock cells_in(const TerrainWindow& window, const std::optional<GeoReference>& place, int nx,
                   int ny, const std::string& file) {
    const GeoReference grid = place.value_or(GeoReference{});
    const char* unit = place ? "" : " in cells";
    const double x = first_from(window.west, grid.west, grid.dx);
    const double y = first_from(window.south, grid.south, grid.dy);
    const double end_x = first_from(window.east, grid.west, grid.dx);
    const double end_y = first_from(window.north, grid.south, grid.dy);
    if (!(x >= 0.0 && y >= 0.0 && end_x <= nx && end_y <= ny))
        refuse_window(window, grid, nx, ny, unit, file, "reaches beyond the file");
    if (!(end_x > x && end_y > y))
        refuse_window(window, grid, nx, ny, unit, file, "is smaller than a cell");
    return {static_cast<int>(x), static_cast<int>(y), static_cast<int>(end_x - x),
            static_cast<int>(end_y - y)};
}

GeoReference place_of(const CellBlock& block, GeoReference grid) {
    grid.west += block.x * grid.dx;
    grid.south += block.y * grid.dy;
    return grid;
}

void crop(Terrain& terrain, const std::optional<TerrainWindow>& window, const std::string& file) {
    if (!window) return;
    const CellBlock block =
        cells_in(*window, terrain.place, terrain.heights.nx(), terrain.heights.ny(), file);
    terrain.heights = cut(terrain.heights, block);
    if (!terrain.nodata.empty()) terrain.nodata = cut(terrain.nodata, block);
    if (terrain.place) terrain.place = place_of(block, *terrain.place);
    const auto holes = std::ranges::count(terrain.nodata.values(), 1);
    if (holes == static_cast<std::ptrdiff_t>(terrain.heights.size()))
        throw InputError(
            fmt::format("{}: no cell in bed.window holds data; take another part", file));
    if (holes == 0) terrain.nodata = {};
}

}  // namespace fumon
