#pragma once

#include <optional>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// A grid onto whose cells something is brought.
struct CellLattice {
    int nx = 0;
    int ny = 0;
    std::optional<GeoReference> place{};  ///< none where it does not say
};

/// What a file holds (rain, roughness, depths …) at the middles of the cells of another grid, by
/// where both lie: linear between the middles of the four nearest cells of the file that have data,
/// and without data where the cell in which the middle lies has none, or more than half a cell
/// outside the file. A file that names another reference system in metres is reprojected first
/// (GDAL); one that names none is taken to lie in the other grid's. Where either of them does not
/// say where it lies, both must have as many cells, which are taken one by one.
/// Throws InputError "what is wrong; what would be right" where they have not, or one counts
/// degrees and the other metres without naming a system, or GDAL cannot reproject.
Terrain on_cells(const Terrain& map, const CellLattice& lattice);

}  // namespace fumon
