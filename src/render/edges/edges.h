#pragma once

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// What the ground about a cell has of an edge: how much of one, 0 … 1, how much a bicubic may cut
/// off it, and where it runs.
struct Edge {
    float share = 0.0F;
    float most = 0.0F;
    float east = 0.0F;  // along it, the longer the straighter it is: at most 1
    float north = 0.0F;
};

/// Mixes into fine heights, as far as there is an edge, their means along it, over up to so many
/// coarse cells to either side: an edge then runs on where the lattice breaks it up. Independent of
/// the pool's size.
void smooth_along_edges(const Field<Edge>& edge, int refinement, float cells_aside,
                        Field<float>& fine, WorkerPool& pool);

}  // namespace fumon
