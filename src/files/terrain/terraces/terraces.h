#pragma once

#include <optional>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// The step of which all heights of a terrain are multiples, from its first one on, in metres: the
/// largest of 10, 5, 2, 1, ½, ¼, ⅕ and ⅒, of a metre, of either foot and of the file's own numbers.
/// Nothing where they are no multiples of any of these, where all heights are one, and where the
/// heights are too large for single precision to tell.
std::optional<double> height_step(const Terrain& terrain);

/// Whether steps of that size are seen as terraces: at least 32 × 32 cells, eight steps from the
/// lowest to the highest, and a quarter of all neighbours as high as each other.
bool has_terraces(const Terrain& terrain, double step);

/// The heights of a terrain in steps, without its terraces: the surface of least bending (a thin
/// plate, free at edges and holes) among those that differ from the heights by half a step at most,
/// which is as far as rounding has moved them. dx and dy may differ.
///
/// Water stays level: a connected area of one height that holds a square of 17 × 17 cells and whose
/// neighbours are higher for at least nineteen in twenty.
///
/// From coarse cells to fine ones, a fixed number of relaxations each: what is left of the equation
/// is not to be seen, and is not zero. The same terrain gives the same heights anywhere.
Grid without_terraces(const Terrain& terrain, double step, double dx, double dy);

}  // namespace fumon
