#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/geo_reference.h"
#include "files/gdal/gdal_types.h"

namespace fumon {

/// Where a raster lies as its file tells it, and how its rows and columns run.
struct RasterGeoReference {
    std::optional<GeoReference> grid{};  ///< of the whole raster; none where the file does not say
    bool north_first = true;             ///< the first row is the northernmost
    bool west_first = true;              ///< the first column is the westernmost
    bool units_known = false;            ///< whether a system tells degrees from lengths
    double metres_per_height = 1.0;      ///< of the heights of a compound system
    std::string height_unit{};           ///< its name; empty where the system has no heights
    bool heights_point_down = false;     ///< depths below a level
};

/// Reads the place of an open raster of nx × ny cells. A GdalSession is held. `refuse` throws for
/// (what is wrong, remedy): rotated or skewed cells, ground control points, rational
/// polynomials (RPC), arrays of coordinates, cells of no size,
/// angles that are no degrees.
RasterGeoReference raster_georeference(
    GDALDatasetH dataset, int nx, int ny,
    const std::function<void(std::string_view what, std::string_view remedy)>& refuse);

}  // namespace fumon
