#pragma once

#include <string>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// A terrain brought onto even cells in metres of another coordinate reference system, by GDAL's
/// warper: `crs` is "utm" (the zone of its middle, WGS 84, for a terrain in degrees) or what GDAL
/// and PROJ know ("EPSG:32613", WKT). Heights between cells are bilinear, cells are square and
/// about as many as before, and what the old grid does not cover has no data. A terrain in degrees
/// that names no system is taken for WGS 84. Its note then says what was done. Throws InputError
/// where the terrain lies nowhere or names no system, or where the wanted one is unknown, in
/// degrees or not in metres; Error where fumon was built without GDAL.
Terrain reprojected(const Terrain& terrain, const std::string& crs);

}  // namespace fumon
