#include "files/terrain/reproject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"
#include "files/terrain/esri_ascii.h"

namespace fumon {

namespace {

bool in_metres(const SpatialReference& crs) {
    return crs.is_projected() && crs.length().metres == 1.0;
}

/// The zone of WGS 84 / UTM in which the middle of a grid in degrees lies.
std::string utm_zone(const GeoReference& place, const Grid& heights) {
    const double longitude = place.west + 0.5 * place.dx * heights.nx();
    const double latitude = place.south + 0.5 * place.dy * heights.ny();
    const double turned = longitude - 360.0 * std::floor((longitude + 180.0) / 360.0);
    const int zone = std::clamp(static_cast<int>((turned + 180.0) / 6.0) + 1, 1, 60);
    constexpr int north = 32600;
    constexpr int south = 32700;
    return fmt::format("EPSG:{}", (latitude >= 0.0 ? north : south) + zone);
}

std::string wanted_system(const Terrain& terrain, const std::string& crs) {
    if (crs != "utm" && crs != "UTM") return crs;
    if (terrain.place->degrees) return utm_zone(*terrain.place, terrain.heights);
    throw InputError(
        "\"utm\" needs a terrain in degrees, and this one is already projected; name a reference "
        "system, for example \"EPSG:32613\"");
}

/// The terrain as a raster of GDAL's in memory, north first.
void write_rows(GDALDatasetH dataset, const Terrain& terrain, double missing) {
    const Grid& heights = terrain.heights;
    const GeoReference& place = *terrain.place;
    const double north = place.south + place.dy * heights.ny();
    std::array<double, 6> transform{place.west, place.dx, 0.0, north, 0.0, -place.dy};
    gdal().GDALSetGeoTransform(dataset, transform.data());
    GDALRasterBandH band = gdal().GDALGetRasterBand(dataset, 1);
    gdal().GDALSetRasterNoDataValue(band, missing);
    std::vector<double> row(static_cast<std::size_t>(heights.nx()));
    for (int y = heights.ny() - 1; y >= 0; --y) {
        for (int x = 0; x < heights.nx(); ++x) {
            const bool hole = !terrain.nodata.empty() && terrain.nodata(x, y) != 0;
            row[static_cast<std::size_t>(x)] = hole ? missing : heights(x, y);
        }
        if (gdal().GDALRasterIO(band, GF_Write, 0, heights.ny() - 1 - y, heights.nx(), 1,
                                row.data(), heights.nx(), 1, GDT_Float64, 0, 0) != CE_None)
            return;  // the session knows why
    }
}

/// Reads a warped raster, whose rows run from north to south.
Terrain read_rows(GDALDatasetH dataset, double missing, const std::string& wkt) {
    const int nx = gdal().GDALGetRasterXSize(dataset);
    const int ny = gdal().GDALGetRasterYSize(dataset);
    if (static_cast<long long>(nx) * ny > largest_grid_cells) {
        throw InputError(
            fmt::format("{} x {} cells after reprojection; at most {} are possible, so choose a "
                        "part of the file with bed.window",
                        nx, ny, largest_grid_cells));
    }
    std::array<double, 6> transform{};
    gdal().GDALGetGeoTransform(dataset, transform.data());
    Terrain terrain;
    terrain.heights = Grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        std::span<double> row = terrain.heights.row(y);
        if (gdal().GDALRasterIO(gdal().GDALGetRasterBand(dataset, 1), GF_Read, 0, ny - 1 - y, nx, 1,
                                row.data(), nx, 1, GDT_Float64, 0, 0) != CE_None)
            return terrain;
        for (int x = 0; x < nx; ++x) {
            double& height = row[static_cast<std::size_t>(x)];
            if (height != missing && std::isfinite(height)) continue;
            if (terrain.nodata.empty()) terrain.nodata = Mask(nx, ny);
            terrain.nodata(x, y) = 1;
            height = 0.0;
        }
    }
    terrain.dx = transform[1];
    terrain.dy = -transform[5];
    terrain.place = GeoReference{
        transform[0], transform[3] - terrain.dy * ny, terrain.dx, terrain.dy, false, wkt};
    return terrain;
}

/// What a terrain's reader said, without how it took degrees for metres.
std::string other_notes(const std::string& note) {
    std::string others;
    for (std::size_t begin = 0; begin < note.size();) {
        const std::size_t end = std::min(note.find("; ", begin), note.size());
        const std::string part = note.substr(begin, end - begin);
        if (part.find("converted to metres at the middle latitude") == std::string::npos)
            others += part + "; ";
        begin = end + 2;
    }
    return others;
}

}  // namespace

Terrain reprojected(const Terrain& terrain, const std::string& crs) {
    if (!terrain.place || (terrain.place->crs.empty() && !terrain.place->degrees)) {
        throw InputError(
            "the file has no coordinate reference system; write one into it (gdal_edit.py -a_srs), "
            "or a .prj file beside an ESRI ASCII grid");
    }
    const GdalSession session;
    const std::string wanted = wanted_system(terrain, crs);
    const SpatialReference to(wanted);
    if (!to.understood()) {
        throw InputError(
            fmt::format("\"{}\" is not a reference system known to PROJ; write \"utm\" or one like "
                        "\"EPSG:32613\"",
                        crs));
    }
    if (!in_metres(to)) {
        throw InputError(fmt::format(
            "\"{}\" is not in metres; choose a projected system in metres, or \"utm\"", crs));
    }
    const std::string to_wkt = to.wkt();
    const SpatialReference from(terrain.place->crs.empty() ? "EPSG:4326" : terrain.place->crs);
    const std::string from_wkt = from.wkt();
    const double missing = unused_height(terrain.heights);
    GdalDataset source(gdal().GDALCreate(gdal().GDALGetDriverByName("MEM"), "",
                                         terrain.heights.nx(), terrain.heights.ny(), 1, GDT_Float64,
                                         nullptr));
    Terrain result;
    if (source.get() != nullptr) {
        write_rows(source.get(), terrain, missing);
        constexpr double pixels_off = 0.125;  // of the approximated transformation, at most
        GdalDataset warped(gdal().GDALAutoCreateWarpedVRT(
            source.get(), from_wkt.c_str(), to_wkt.c_str(), GRA_Bilinear, pixels_off, nullptr));
        if (warped.get() != nullptr) result = read_rows(warped.get(), missing, to_wkt);
    }
    if (!session.fault().empty() || result.heights.empty())
        throw InputError(fmt::format("cannot be reprojected to \"{}\": {}", crs, session.fault()));
    result.note = other_notes(terrain.note) +
                  fmt::format("reprojected to {}: {} x {} cells of {:.6g} m", wanted,
                              result.heights.nx(), result.heights.ny(), result.dx);
    return result;
}

}  // namespace fumon
