#pragma once

#include "models/water/kernels/cip_vectors.h"

namespace fumon::cip {

/// A quantity with its gradient, which is kept per cell: ∂f/∂x·dx and ∂f/∂y·dy.
struct AdvectedStencil {
    Stencil value;
    Stencil gradient_x;
    Stencil gradient_y;
};

struct AdvectedRow {
    double* value;
    double* gradient_x;
    double* gradient_y;
};

/// Advects a quantity with the velocity: the value and the gradient of its cubic interpolation at
/// the place the water came from, in the cell upwind (CIP, type A: Yabe, Ishikawa, Wang, Aoki,
/// Kadota & Ikeda 1991, Comput. Phys. Commun. 66).
void advect_row(const AdvectedStencil& before, const Velocity& by, const SubStep& step, int count,
                const AdvectedRow& after);

/// The same of the velocities themselves. Where `held`, a value stays between the four that it
/// comes from: no extremum of its own.
void advect_velocities(const AdvectedStencil& u, const AdvectedStencil& v, const SubStep& step,
                       bool held, int count, const AdvectedRow& u_after,
                       const AdvectedRow& v_after);

}  // namespace fumon::cip
