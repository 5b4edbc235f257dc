#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// A row of cells that hold means, as their faces across one axis and their own water see them.
struct MeanRow {
    double* depth;
    double* surface;
    double* normal;      ///< velocity, of the mean along the faces
    double* transverse;  ///< likewise
    double* slope;       ///< half of the surface's, of the mean by depth
};

/// What the two faces toward `back` and `forward` see of `count` cells, of which depth and surface
/// are means and velocities momentum over depth. With half slopes s the means of a parabola give
/// its values at the faces
///
///     h ± s + (h_back − 2 h + h_forward) / 12.
///
/// Water of linear velocity u, where it is deeper, carries (∂h/∂x ∂u/∂x) Δx² / (12 h) more than the
/// velocity at the cell's middle, which goes from `normal` and `transverse`; the slopes of both, of
/// which the differences of these terms are a part, become those of u. And what water feels of the
/// surface's slope has (∂h/∂x ∂²η/∂x²) Δx² / (12 h) more than at the middle. Where the water is
/// thinner than the bed's steps, all is as without these terms. Second differences count up to
/// twice the smaller of the two differences, slopes of the depth up to twice the depth.
void means_to_faces(const CellRow& back, const CellRow& here, const CellRow& forward,
                    const HalfSlopes& slopes, const MeanRow& out, int count);

}  // namespace fumon::finite_volume
