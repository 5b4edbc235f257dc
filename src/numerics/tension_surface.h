#pragma once

#include "base/grid.h"

namespace fumon {

/// Fills in the cells of a doubly periodic field whose `unknown` is not 0, as a thin plate in
/// tension through the others: (1 − T)∇⁴f = T∇²f with T = 0.35 (Smith & Wessel 1990), so that value
/// and slope go on from known cells. By relaxation from coarse cells to fine ones: what is left of
/// the equation is nowhere to be seen, and is not zero. Leaves the field as it is where nothing is
/// known.
void fill_in_tension(Grid& field, const Mask& unknown);

/// How far each cell of a doubly periodic lattice is from the nearest one whose `goal` is not 0,
/// cells: along both axes and diagonals (Borgefors 1986). Very large where there is none.
Field<float> distances_to(const Mask& goal);

}  // namespace fumon
