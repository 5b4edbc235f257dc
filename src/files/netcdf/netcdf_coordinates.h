#pragma once

#include <optional>
#include <string>

#include "base/grid.h"

namespace fumon {

/// How the coordinates of a fields file run: x = west + (i + 0.5)·dx, y = south + (j + 0.5)·dy.
struct FileCoordinates {
    double west = 0.0;
    double south = 0.0;
    double dx = 1.0;
    double dy = 1.0;
    bool degrees = false;
    std::string unit = "m";  ///< of coordinates that are lengths, as UDUNITS knows it
    bool has_crs = false;    ///< a variable `crs` tells the coordinate reference system
};

/// Where a grid lies in a file: in its reference system where that counts degrees or a length that
/// UDUNITS knows (metres, kilometres, feet; its cells are then the system's, not the ground's),
/// else (sites, links, or nowhere) in metres or sites from its south-west corner.
FileCoordinates file_coordinates(const WorldScale& scale);

/// Defines the scalar variable `crs` of a scale whose place has one: grid_mapping_name and its
/// parameters (grid_mapping.h) where CF knows the projection, and the whole system as WKT in
/// crs_wkt, which CF knows, and spatial_ref, which GDAL writes. The caller holds the NetcdfLock.
/// Throws NetcdfFault.
void define_crs(int file, const WorldScale& scale);

/// Says that a field lies in that system. By CF a grid_mapping has a grid_mapping_name, which there
/// is none of for Krovak's projection and others that CF does not know; GDAL finds their crs_wkt by
/// grid_mapping alone, so that they have one all the same. A system in degrees is always known.
void put_grid_mapping(int file, int field);

}  // namespace fumon
