#pragma once

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// Resamples heights to cells `refinement` times finer, like refined(), but leaves edges between
/// cells as edges: where the slope of neighbouring cells differs by 0.2 or more, wholly from 0.45
/// on, heights between them lie on the planes that lead there from either side, the lower one over
/// a brink and the higher one at the foot of a slip face (as Harten, 1989, finds edges within
/// cells). About an edge heights are averaged along it over up to three cells to either side, since
/// the lattice breaks it up: a low sun shows that in the edges of shadows. `dx`, `dy`: sides of a
/// coarse cell, in units of the heights. Looks eight cells around; beyond the border the edge cells
/// are repeated. Independent of the pool's size.
Field<float> refined_with_brinks(const Field<float>& heights, float dx, float dy, int refinement,
                                 WorkerPool& pool);

}  // namespace fumon
