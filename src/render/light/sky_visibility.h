#pragma once

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// The share of a uniform sky's light that reaches every cell: the cosine-weighted part of the sky
/// left free by the terrain, seen from the tilted surface; 1 on a plain.
///
/// In the 8 directions of the lattice the horizon is found by sweeping each line with the upper
/// convex hull of what has been passed (Timonen & Westerholm 2010); the sky above it is integrated
/// in closed form for the tilted normal (Kennelly & Stewart 2006, 2014):
///     E = n_z/π · Σ Δφ · [ −g·(π/2 − θ − sin θ cos θ)/2 + cos² θ / 2 ]
/// with the horizon's elevation θ and the slope g towards it. O(cells) in each direction.
///
/// `heights`, `dx` and `dy` are in one unit of length. Cells of a margin on each side hide the sky
/// from the others, which alone are returned. Independent of the pool's size.
Field<float> sky_visibility(const Field<float>& heights, float dx, float dy, WorkerPool& pool,
                            int margin = 0);

}  // namespace fumon
