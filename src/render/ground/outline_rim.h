#pragma once

#include <cstdint>
#include <vector>

#include "render/ground/terrain_mesh.h"
#include "render/view/display_bed.h"

namespace fumon {

/// Moves the vertices at cells without data to the outline of the bed (DisplayBed::outline), those
/// on the border of the bed along it, and returns which these are. `bed` is the one that the
/// lattice was made for.
std::vector<std::uint32_t> move_rim(TerrainLattice& lattice, const DisplayBed& bed);

/// The faces along the rims of cells without data, so that the block looks solid. Where they go on
/// at less than about 45 degrees their directions pass into each other. `aspect`: of the bed, its
/// length eastward over that northward.
std::vector<SideFace> rim_faces(const TerrainLattice& lattice, float aspect);

}  // namespace fumon
