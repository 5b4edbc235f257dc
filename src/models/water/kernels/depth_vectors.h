#pragma once

#include "models/water/kernels/cip_vectors.h"

namespace fumon::cip {

/// The advected depth less h ∇·u, as published, and what it gained.
void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained);

/// Cells on either side of faces, two in each direction, and velocities next to them.
struct FaceCells {
    const double* depth_before;  ///< of the cell behind `depth_here`
    const double* depth_here;
    const double* depth_next;
    const double* depth_after;
    const double* speed_here;
    const double* speed_next;
};

/// Depth that passes faces, onward where positive: second order in space and time with the
/// monotonised central limiter (van Leer 1977, J. Comput. Phys. 23). `per_cell` is dt/dx.
void through_faces(const FaceCells& cells, double per_cell, int count, double* faces);

/// Depths after the faces have passed theirs and `rain` (m) has fallen; whether a cell gave more
/// than it had. faces_x[x − 1] and faces_x[x] lie west and east of cell x.
bool settle_row(const double* before, const double* faces_x, const double* faces_south,
                const double* faces_north, double rain, int count, double* after);

}  // namespace fumon::cip
