#pragma once

#include <vector>

#include "files/terrain/terrain_format.h"

namespace fumon {

/// A terrain as a GeoTIFF, see geotiff.h. Throws Error where GDAL fails.
std::vector<TerrainBytes> write_geotiff(const TerrainOutput& terrain);

/// The same as a Cloud Optimized GeoTIFF. Throws Error where GDAL fails.
std::vector<TerrainBytes> write_cloud_geotiff(const TerrainOutput& terrain);

}  // namespace fumon
