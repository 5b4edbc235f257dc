#pragma once

#include <vector>

#include "files/terrain/terrain_format.h"

namespace fumon {

/// A terrain as a GeoTIFF, see geotiff.h. Throws Error where GDAL fails.
std::vector<TerrainBytes> write_geotiff(const TerrainOutput& terrain);

}  // namespace fumon
