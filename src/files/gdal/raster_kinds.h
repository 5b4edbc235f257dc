#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace fumon {

/// Whether a file is a VRT of GDAL's, which names the parts of a raster and their files.
bool is_vrt(const std::filesystem::path& file, std::string_view start);

/// Whether a file's first bytes or its ending are those of a VRT, or of a TIFF (of either byte
/// order, of 32 or 64 bits).
bool is_geotiff(const std::filesystem::path& file, std::string_view start);

/// Whether a file is a raster of another kind that GDAL reads: by its ending or first bytes
/// (ERDAS .img, GeoPackage, JPEG 2000, SRTM .hgt, DTED, USGS DEM, Surfer .grd, XYZ, ENVI, ESRI
/// .bil and .flt, PCRaster, Zarr …), or, where it is neither NetCDF, PNG nor an ESRI ASCII grid,
/// because GDAL says so.
bool is_other_raster(const std::filesystem::path& file, std::string_view start);

/// GDAL's names of the drivers that may read a file, up to a null pointer. Of files of unknown
/// origin only those whose formats name no other file.
std::span<const char* const> raster_drivers(bool trusted);

}  // namespace fumon
