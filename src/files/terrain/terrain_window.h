#pragma once

#include <optional>
#include <string>

#include "base/geo_reference.h"

namespace fumon {

struct Terrain;

/// The part of a terrain file to read: in the file's coordinates, or in cells from its
/// south-western corner where the file has none.
struct TerrainWindow {
    double west = 0.0;
    double south = 0.0;
    double east = 0.0;
    double north = 0.0;
};

/// A block of cells, counted from the south-western corner.
struct CellBlock {
    int x = 0;
    int y = 0;
    int nx = 0;
    int ny = 0;
};

/// The cells of an nx × ny grid whose centres lie in a window: from its western and southern edge
/// on, up to but without its eastern and northern one. Throws InputError "FILE: what; remedy" where
/// the window reaches half a cell or more beyond the grid, or holds no cell's centre.
CellBlock cells_in(const TerrainWindow& window, const std::optional<GeoReference>& place, int nx,
                   int ny, const std::string& file);

/// Where a block of cells of a grid lies.
GeoReference place_of(const CellBlock& block, GeoReference grid);

/// Cuts a window out of a terrain that was read as a whole. Throws as cells_in().
void crop(Terrain& terrain, const std::optional<TerrainWindow>& window, const std::string& file);

}  // namespace fumon
