#include "files/terrain/geotiff.h"

#include "files/gdal/gdal_functions.h"
#include "files/gdal/raster_kinds.h"
#include "files/terrain/geotiff_writer.h"
#include "files/terrain/raster.h"

namespace fumon {

TerrainFormat geotiff_format() {
    return {.name = "geotiff",
            .title = "a GeoTIFF",
            .is_one = is_geotiff,
            .read = read_raster,
            .write = write_geotiff,
            .endings = {".tif"},
            .has_units = true,
            .has_variables = true,
            .has_bands = true,
            .missing = missing_gdal};
}

TerrainFormat cloud_geotiff_format() {
    return {.name = cloud_geotiff_name,
            .title = "a Cloud Optimized GeoTIFF",
            .is_one = [](const std::filesystem::path&, std::string_view) { return false; },
            .read = read_raster,
            .write = write_cloud_geotiff,
            .endings = {".cog.tif"},
            .has_units = true,
            .has_bands = true,
            .missing = missing_gdal};
}

}  // namespace fumon
