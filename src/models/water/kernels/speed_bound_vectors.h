#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// Cells whose water gets no faster than a speed where it is thin.
struct SpeedBounds {
    double* speed;  ///< m/s
    double* thin;   ///< that of no greater depth, m
};

/// The largest Riemann invariants |u| + 2√(g h) of a row of cells, m/s.
void largest_invariants(const CellRow& cells, double gravity, double* out, int count);

struct InvariantRow {
    CellRow cells;
    const double* largest;  ///< as above
};

/// A row of cells and the next ones to the south and north. Each begins one cell before the first
/// that gets a bound.
struct RowsAround {
    InvariantRow south;
    InvariantRow here;
    InvariantRow north;
};

struct BoundFactors {
    double dx = 1.0;       ///< m
    double dy = 1.0;       ///< m
    double gravity = 9.8;  ///< m/s²
    double pulled = 0.0;   ///< what the mean plane's slope adds within a step, m/s
    double dt = 0.0;       ///< s
};

/// How fast thin water may become within a step. The exact flow carries u ± 2√(g h) along its
/// characteristics, none of which comes from farther than the next cells, and the bed adds what its
/// slope pulls: so no more than
///
///     max(|u| + 2√(g h)) + dt·g·|∇z|
///
/// over a cell and the four beside it. Water is thin that is no deeper than the largest of the
/// bed's steps between them.
void speed_bounds(const RowsAround& rows, const BoundFactors& factors, const SpeedBounds& out,
                  int count);

}  // namespace fumon::finite_volume
