#pragma once

#include <filesystem>

#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

/// Reads one band of a raster file of any kind in raster_kinds.h, by GDAL.
///
/// Values are of any real type, raw × scale + offset, converted to metres where the band or the
/// vertical part of a compound coordinate reference system names another length, and negated where
/// that system's vertical axis points down. Signed bytes of older files are told by their
/// PIXELTYPE. Cells equal to the band's no-data value, NaN, or hidden by the file's mask (internal,
/// external, alpha) hold no data. Of a window only that part is read, however large the file is.
/// Origin, cell size and coordinate reference system are the file's; lengths of cells in the file's
/// unit (ground_lengths.h makes metres of them). A file that does not say where it lies has no cell
/// size, and its first row is the northernmost. A container with several grids is read where
/// `query.variable` names one. Files that belong to it by their names (.msk, .aux.xml, .hdr, .tfw)
/// are read with it where `query.trusted`.
/// Throws InputError "FILE: what; remedy" for a damaged or truncated file, rotated or skewed cells,
/// a placement by ground control points, colour pictures and complex numbers, a band or grid that
/// is not there, more than `largest_grid_cells` cells, infinite heights, units that are no lengths,
/// where no cell holds data, where GDAL is not installed, and for a VRT that names a file by /vsi…
/// or a URL, or is not trusted.
Terrain read_raster(const std::filesystem::path& file, const TerrainQuery& query);

/// Rasters other than GeoTIFF as a terrain format, which is only read.
TerrainFormat other_raster_format();

}  // namespace fumon
