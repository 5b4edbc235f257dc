#pragma once

#include <filesystem>
#include <string>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// The coordinate reference system in the .prj file beside a grid, as WKT on one line; empty where
/// there is none. Lines of words, as ARC/INFO wrote them, are GDAL's to read. What cannot be read
/// is passed over, and the terrain's note says so.
std::string crs_beside(const std::filesystem::path& grid, Terrain& terrain);

}  // namespace fumon
