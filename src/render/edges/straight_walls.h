#pragma once

#include <optional>

#include "base/grid.h"
#include "render/edges/edges.h"

namespace fumon {

class WorkerPool;

/// Where a periodic bed has walls of rock, and its heights with straight ones.
struct StraightWalls {
    Field<Edge> edges;    ///< the walls, of coarse cells
    Field<float> coarse;  ///< heights
    Field<float> fine;
};

/// Straight walls of rock, nullopt where there are none: where ground rises from
/// one cell to the next more steeply than three cells before and after, by a slope of 1.5 or more,
/// wholly from 2.25 on, which sand does not. Of such a wall the cells tell little more than on
/// which side of it they lie, so that its rim, its foot and the shadows on it are stairs where it
/// runs oblique to them. Heights about it are averaged along it, over up to six
/// cells to either side, the fewer the more it turns (the direction in which slopes vary the most
/// lies across it: Bigün & Granlund 1987), and stay within those of the four cells around, which
/// bicubics leave beside a step. Coarse cells there get the means of their fine ones. `dx`, `dy`:
/// sides of a coarse cell without exaggeration, in units of the heights. Independent of the pool's
/// size, and of where the bed begins.
std::optional<StraightWalls> with_straight_walls(const Field<float>& coarse,
                                                 const Field<float>& fine, float dx, float dy,
                                                 WorkerPool& pool);

/// Numbers of a periodic bed's fine cells with means along its walls, over up to so many coarse
/// cells to either side.
Field<float> averaged_along(const Field<Edge>& walls, float cells_aside, const Field<float>& fine,
                            WorkerPool& pool);

}  // namespace fumon
