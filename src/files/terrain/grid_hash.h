#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/sha256.h"

namespace fumon {

/// A file that decides what a grid is.
struct GridPart {
    std::filesystem::path file;
    std::string role;  ///< its ending (".tif.msk"), or how a VRT names it
};

/// The files beside a grid that count with it where they are there, sorted by their roles: masks
/// (.msk), what GDAL notes of it (.aux.xml, unless that holds nothing but statistics), world files
/// (.tfw, .jgw, .wld …), headers (.hdr …), reference systems (.prj), and the files that a VRT
/// names, with theirs. None beside NetCDF files and PNGs, and no overviews, which change no height.
std::vector<GridPart> grid_parts(const std::filesystem::path& grid);

/// SHA-256 of everything that decides a grid. That of its bytes (file_hash) where nothing beside it
/// counts; else over a line of role, LF, hash (hexadecimal), LF for the grid and each of its parts;
/// of an .aux.xml without its statistics. Throws as read_input_file.
Sha256 grid_hash(const std::filesystem::path& grid);

/// Whether a path leads to a grid (a regular file or Zarr store) of this grid_hash() (hexadecimal)
/// that can be read.
bool has_grid_hash(const std::filesystem::path& grid, const std::string& hash);

}  // namespace fumon
