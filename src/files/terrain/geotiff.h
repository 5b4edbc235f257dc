#pragma once

#include <string>
#include <string_view>

#include "base/geo_reference.h"
#include "base/image.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

/// GeoTIFF files as a terrain format, read and written by GDAL; VRT files, which put rasters of
/// several files together, are read likewise (no /vsi… and no URL in them).
///
/// Read: one band of numbers of any real type, raw × scale + offset, converted to metres where its
/// unit is another length. Cells equal to the band's no-data value, NaN, or transparent in the
/// file's mask or alpha band hold no data. Of a window only that part is read, however large the
/// file is. Origin, cell size and coordinate reference system come from the file itself, never from
/// a world file beside it; cells become metres, from degrees at the middle latitude (without a
/// coordinate reference system is_geographic() tells degrees). A file that does not say where it
/// lies has no cell size, and its first row is the northernmost.
/// Throws InputError "FILE: what; remedy" for a damaged or truncated file, rotated or skewed cells,
/// a placement by ground control points, colour pictures and complex numbers, a band that is not
/// there, more than `largest_grid_cells` cells, infinite heights, units that are no lengths, and
/// where no cell holds data.
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
/// fails or there is none.
std::string geotiff_picture(const Image& picture, const GeoReference& place);

/// A coordinate reference system (WKT) as .prj files have it; as it stands where it is WKT 1
/// already, or cannot be told so.
std::string esri_projection(const std::string& crs);

}  // namespace fumon
