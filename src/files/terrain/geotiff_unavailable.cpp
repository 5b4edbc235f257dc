// In the place of geotiff.cpp and geotiff_writer.cpp where fumon is built without GDAL.

#include <fmt/format.h>

#include "base/error.h"
#include "files/terrain/geotiff.h"
#include "files/terrain/geotiff_signature.h"
#include "files/terrain/reproject.h"

namespace fumon {

namespace {

constexpr const char* remedy =
    "install libgdal-dev (apt-get install libgdal-dev) and build fumon again";

Terrain refuse_geotiff(const std::filesystem::path& file, const TerrainQuery&) {
    throw InputError(fmt::format(
        "{}: is a GeoTIFF, and this fumon was built without GDAL; {}, or make an ESRI ASCII grid "
        "of it (gdal_translate -of AAIGrid)",
        file.string(), remedy));
}

std::vector<TerrainBytes> write_no_geotiff(const TerrainOutput&) {
    throw Error(fmt::format("a GeoTIFF cannot be written without GDAL; {}", remedy));
}

}  // namespace

TerrainFormat geotiff_format() {
    return {.name = "geotiff",
            .title = "a GeoTIFF",
            .is_one = is_geotiff,
            .read = refuse_geotiff,
            .write = write_no_geotiff,
            .endings = {".tif"},
            .has_bands = true,
            .lacks = remedy};
}

TerrainFormat cloud_geotiff_format() {
    TerrainFormat format = geotiff_format();
    format.name = cloud_geotiff_name;
    format.title = "a Cloud Optimized GeoTIFF";
    format.is_one = [](const std::filesystem::path&, std::string_view) { return false; };
    format.endings = {".cog.tif"};
    return format;
}

Terrain reprojected(const Terrain&, const std::string&) {
    throw InputError(fmt::format("needs GDAL, and this fumon was built without it; {}", remedy));
}

std::string geotiff_picture(const Image&, const GeoReference&) {
    throw Error(fmt::format("a GeoTIFF cannot be written without GDAL; {}", remedy));
}

std::string esri_projection(const std::string& crs) {
    return crs;
}

}  // namespace fumon
