#include "files/gdal/raster_choice.h"

#include <string_view>

#include "files/gdal/gdal_functions.h"

namespace fumon {

namespace {

/// "/dem" of ZARR:"file":/dem, "2" of GTIFF_DIR:2:file, "dem" of GPKG:file:dem.
std::string name_of(std::string_view path) {
    if (path.starts_with("GTIFF_DIR:")) {
        path.remove_prefix(path.find(':') + 1);
        return std::string(path.substr(0, path.find(':')));
    }
    path = path.substr(path.rfind(':') + 1);
    while (path.starts_with('/')) path.remove_prefix(1);
    return std::string(path);
}

}  // namespace

std::vector<ContainedGrid> contained_grids(GDALDatasetH dataset) {
    std::vector<ContainedGrid> grids;
    char** entries = gdal().GDALGetMetadata(dataset, "SUBDATASETS");
    for (; entries != nullptr && *entries != nullptr; ++entries) {
        const std::string_view entry(*entries);
        const std::size_t equals = entry.find("_NAME=");
        if (equals == std::string_view::npos) continue;
        const std::string_view path = entry.substr(equals + 6);
        grids.push_back({name_of(path), std::string(path)});
    }
    return grids;
}

}  // namespace fumon
