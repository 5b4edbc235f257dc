#pragma once

#include <string>
#include <vector>

#include "files/gdal/gdal_types.h"

namespace fumon {

/// One of the grids that a container holds (GeoPackage, Zarr, a TIFF of several pages).
struct ContainedGrid {
    std::string name;  ///< as bed.variable names it: a table, an array, a page's number
    std::string path;  ///< by which GDAL opens it
};

/// The grids of a dataset that is a container; empty for a single raster.
std::vector<ContainedGrid> contained_grids(GDALDatasetH dataset);

}  // namespace fumon
