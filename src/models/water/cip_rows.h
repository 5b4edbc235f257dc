#pragma once

namespace fumon::cip {

/// A row and its two neighbours: the same cells of each, readable a cell past either end.
struct Stencil {
    const double* south;
    const double* here;
    const double* north;
};

/// A quantity with its gradient, which is kept per cell: ∂f/∂x·dx and ∂f/∂y·dy.
struct CarriedStencil {
    Stencil value;
    Stencil gradient_x;
    Stencil gradient_y;
};

struct CarriedRow {
    double* value;
    double* gradient_x;
    double* gradient_y;
};

/// What all rows of a sub-step share.
struct SubStep {
    double dt;        ///< s
    double dx;        ///< m
    double dy;        ///< m
    double gravity;   ///< m/s²
    double pull;      ///< −g·slope, m/s²
    double friction;  ///< C_f, halved where eq. 9 holds
};

/// Advects a quantity with the velocity (u, v): the value and the gradient of its cubic
/// interpolation at the place the water came from, in the cell upwind (CIP, type A: Yabe, Ishikawa,
/// Wang, Aoki, Kadota & Ikeda 1991, Comput. Phys. Commun. 66).
void advect_row(const CarriedStencil& before, const double* u, const double* v, const SubStep& step,
                int count, const CarriedRow& after);

/// Pressure, the plane's pull and friction after the advection (Saeki & Okamura 2007, eq. 10):
/// velocities and what they gained. Friction is taken half implicitly, at the advected speed, so
/// that thin films come to rest instead of turning round. Dry cells have no velocity.
void accelerate_row(const Stencil& depth, const Stencil& bed, const SubStep& step, int count,
                    const double* advected_u, const double* advected_v, double* u, double* v,
                    double* gained_u, double* gained_v);

/// The same for steep relief: toward a neighbour the surface rises no further than it falls on the
/// other side, or than that neighbour is deep, so that a bank does not press on the water below it.
/// Friction is implicit at the speed that it leaves.
void accelerate_row_steep(const Stencil& depth, const Stencil& bed, const SubStep& step, int count,
                          const double* advected_u, const double* advected_v, double* u, double* v,
                          double* gained_u, double* gained_v);

/// The same with all forces taken before the sub-step, as published.
void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const double* u_before,
                                 const double* v_before, const SubStep& step, int count,
                                 const double* advected_u, const double* advected_v, double* u,
                                 double* v, double* gained_u, double* gained_v);

/// What the non-advective part does to a gradient (Saeki & Okamura 2007, eq. 11, with the cross
/// terms of two dimensions): in place. `gained` is what the value gained beside advection, (u, v)
/// the velocity it was advected with.
void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, double* gradient_x, double* gradient_y);

/// Holds what advect_row gave between the four values that it comes from: no extremum of its own.
void hold_advected_row(const Stencil& before, const double* u, const double* v, int count,
                       double* value);

/// Holds gradients to twice the larger step of the value toward a neighbour: in place.
void hold_gradient_row(const Stencil& value, int count, double* gradient_x, double* gradient_y);

/// The advected depth less h ∇·u, as published, and what it gained.
void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained);

}  // namespace fumon::cip
