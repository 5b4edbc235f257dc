#include "files/terrain/ground_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "files/crs_kind.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"
#include "files/terrain/geographic.h"

namespace fumon {

namespace {

void convert_degrees(Terrain& terrain, const std::string& file) {
    const GeoReference& grid = *terrain.place;
    const double middle = grid.south + 0.5 * grid.dy * terrain.heights.ny();
    if (std::abs(middle) >= 90.0) {
        throw InputError(fmt::format(
            "{}: the middle latitude is {:.6g}°; latitudes lie between -90 and 90", file, middle));
    }
    const MetricCells cells = cells_from_degrees(grid.dx, grid.dy, middle);
    terrain.dx = cells.dx;
    terrain.dy = cells.dy;
    add_note(terrain, cells.note);
}

/// Whether a grid lies where UTM keeps lengths to .1 %, from 180 km to 320 km off the middle of its
/// zone on either side (scale .9996 in the middle).
bool inside_utm_zone(const Terrain& terrain, const CrsKind& kind) {
    constexpr double first = 180000.0;  // m of easting; the middle has 500 km
    constexpr double last = 820000.0;
    const GeoReference& grid = *terrain.place;
    const double middle = grid.west + 0.5 * grid.dx * terrain.heights.nx();
    return kind.utm && kind.metres == 1.0 && middle > first && middle < last;
}

/// The projection's scale at the middle of the grid; none where it cannot be known.
std::optional<SpatialReference::Scale> scale_of(const Terrain& terrain) {
    const GdalSession session;
    const GeoReference& grid = *terrain.place;
    const SpatialReference crs(grid.crs);
    if (!crs.understood() || !crs.is_projected()) return std::nullopt;
    return crs.scale_at(grid.west + 0.5 * grid.dx * terrain.heights.nx(),
                        grid.south + 0.5 * grid.dy * terrain.heights.ny(),
                        std::max(grid.dx, grid.dy));
}

void apply_scale(Terrain& terrain, const SpatialReference::Scale& scale) {
    constexpr double worth_saying = 1e-3;
    constexpr double worth_taking = 1e-2;
    const double deviation = std::max(std::abs(scale.east - 1.0), std::abs(scale.north - 1.0));
    if (deviation <= worth_saying) return;
    if (deviation <= worth_taking) {
        add_note(terrain,
                 fmt::format("lengths on the ground differ from those of the projection by {:.2f} "
                             "% (east) and {:.2f} % (north), which is left as it is",
                             100.0 * (scale.east - 1.0), 100.0 * (scale.north - 1.0)));
        return;
    }
    const double dx = terrain.dx;
    const double dy = terrain.dy;
    terrain.dx *= scale.east;
    terrain.dy *= scale.north;
    add_note(terrain, fmt::format("cells of {:.6g} m × {:.6g} m in the projection are {:.6g} m × "
                                  "{:.6g} m on the ground, which counts",
                                  dx, dy, terrain.dx, terrain.dy));
}

}  // namespace

void make_true_lengths(Terrain& terrain, bool unit_counts, const std::string& file) {
    if (!terrain.place) return;
    GeoReference& grid = *terrain.place;
    const CrsKind kind = crs_kind(grid.crs);
    if (kind.geographic) grid.degrees = true;
    if (kind.projected) grid.degrees = false;
    if (grid.degrees) {
        convert_degrees(terrain, file);
        return;
    }
    if (!kind.projected) return;
    if (unit_counts && kind.metres != 1.0) {
        terrain.dx *= kind.metres;
        terrain.dy *= kind.metres;
        add_note(terrain, fmt::format("cell size converted to metres from {}", kind.unit));
    }
    constexpr double alike = 1e-6;
    const bool in_system = std::abs(grid.dx * kind.metres / terrain.dx - 1.0) < alike;
    if (inside_utm_zone(terrain, kind) || !in_system) return;
    if (!has_gdal() && kind.mercator) {
        throw InputError(
            fmt::format("{}: lies in Mercator's projection, which stretches lengths; to compute by "
                        "how much, fumon {}",
                        file, missing_gdal()));
    }
    if (!has_gdal()) return;
    if (const auto scale = scale_of(terrain)) apply_scale(terrain, *scale);
}

}  // namespace fumon
