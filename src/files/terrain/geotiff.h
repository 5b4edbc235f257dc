#pragma once

#include <string>
#include <string_view>

#include "base/geo_reference.h"
#include "base/image.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

/// GeoTIFF files, and VRT files, which put rasters of several files together, as a terrain format,
/// read by read_raster() and written by GDAL.
///
/// Written: one band of doubles, losslessly compressed, north row first, with origin, cell size and
/// coordinate reference system as the bed's file had them (else metres from (0, 0), else neither),
/// and where cells hold no data a no-data value. The same bytes for the same terrain.
TerrainFormat geotiff_format();

/// Cloud Optimized GeoTIFF, which is only written: the same in tiles of 512 × 512 with overviews,
/// for reading parts of it over a network. What it wrote is read as any GeoTIFF.
TerrainFormat cloud_geotiff_format();

inline constexpr std::string_view cloud_geotiff_name = "cloud-optimized-geotiff";

/// A picture as a GeoTIFF of three bands of 8 bits, losslessly compressed, whose pixels lie at
/// `place` (its cells are pixels). The same bytes for the same picture. Throws Error where GDAL
/// fails, InputError where it is not installed.
std::string geotiff_picture(const Image& picture, const GeoReference& place);

/// A coordinate reference system (WKT) as .prj files have it; as it stands where it is WKT 1
/// already, cannot be told so, or GDAL is not installed.
std::string esri_projection(const std::string& crs);

}  // namespace fumon
