#include "files/gdal/raster_georeference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/gdal/gdal_functions.h"
#include "files/gdal/spatial_reference.h"

namespace fumon {

namespace {

using Refuse = std::function<void(std::string_view, std::string_view)>;

void read_crs(GDALDatasetH dataset, RasterGeoReference& place, const Refuse& refuse) {
    const OGRSpatialReferenceH reference = gdal().GDALGetSpatialRef(dataset);
    if (reference == nullptr) return;
    constexpr std::array<const char*, 3> form{"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
    char* text = nullptr;
    if (gdal().OSRExportToWktEx(reference, &text, form.data()) == OGRERR_NONE && text != nullptr)
        place.grid->crs = text;
    gdal().VSIFree(text);
    if (place.grid->crs.empty()) return;
    const SpatialReference crs(place.grid->crs);
    place.grid->degrees = crs.is_geographic();
    place.units_known = crs.is_geographic() || crs.is_projected() || crs.is_local();
    if (place.grid->degrees && std::abs(crs.degrees_per_unit() - 1.0) > 1e-9)
        refuse("has an angular unit other than degrees", "reproject it to degrees (gdalwarp)");
    if (const auto length = crs.height_length()) {
        place.metres_per_height = length->metres;
        place.height_unit = length->name;
    }
    place.heights_point_down = crs.heights_point_down();
}

}  // namespace

RasterGeoReference raster_georeference(GDALDatasetH dataset, int nx, int ny, const Refuse& refuse) {
    RasterGeoReference place;
    std::array<double, 6> transform{};
    if (gdal().GDALGetGeoTransform(dataset, transform.data()) != CE_None) {
        if (gdal().GDALGetGCPCount(dataset) > 0)
            refuse("is georeferenced by ground control points",
                   "warp it to a regular grid first (gdalwarp)");
        if (gdal().GDALGetMetadata(dataset, "RPC") != nullptr)
            refuse("is georeferenced by rational polynomials (RPC)",
                   "warp it to a regular grid first (gdalwarp -rpc)");
        if (gdal().GDALGetMetadata(dataset, "GEOLOCATION") != nullptr)
            refuse("is georeferenced by arrays of coordinates",
                   "warp it to a regular grid first (gdalwarp -geoloc)");
        return place;
    }
    if (transform[2] != 0.0 || transform[4] != 0.0)
        refuse("has rotated or skewed cells", "warp it to a north-up grid first (gdalwarp)");
    const double dx = transform[1];
    const double dy = -transform[5];
    if (!std::isfinite(dx * dy * transform[0] * transform[3]) || dx == 0.0 || dy == 0.0)
        refuse(fmt::format("has cells of {} x {}", dx, dy), "write a cell size (gdal_edit.py -tr)");
    place.west_first = dx > 0.0;
    place.north_first = dy > 0.0;
    place.grid = {std::min(transform[0], transform[0] + dx * nx),
                  std::min(transform[3], transform[3] - dy * ny), std::abs(dx), std::abs(dy)};
    read_crs(dataset, place, refuse);
    return place;
}

}  // namespace fumon
