#pragma once

namespace fumon::cip {

/// A row and its two neighbours: the same cells of each, readable a cell past either end.
struct Stencil {
    const double* south;
    const double* here;
    const double* north;
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

/// A velocity's components along a row.
struct Velocity {
    const double* u;
    const double* v;
};

/// What accelerating leaves: velocities, and what they gained.
struct Accelerated {
    double* u;
    double* v;
    double* gained_u;
    double* gained_v;
};

/// Pressure, the plane's pull and friction after the advection (Saeki & Okamura 2007, eq. 10):
/// velocities and what they gained. Friction is taken half implicitly, at the advected speed, so
/// that thin films come to rest instead of turning round. Dry cells have no velocity.
void accelerate_row(const Stencil& depth, const Stencil& bed, const SubStep& step,
                    const Velocity& advected, int count, const Accelerated& after);

/// The same for steep relief: toward a neighbour the surface rises no further than it falls on the
/// other side, or than that neighbour is deep, so that a bank does not press on the water below it.
/// Friction is implicit at the speed that it leaves.
void accelerate_row_steep(const Stencil& depth, const Stencil& bed, const SubStep& step,
                          const Velocity& advected, int count, const Accelerated& after);

/// The same with all forces taken before the sub-step, as published.
void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const Velocity& before,
                                 const SubStep& step, const Velocity& advected, int count,
                                 const Accelerated& after);

/// An advected gradient, where it is and where it shall go; they may be the same.
struct TurnedRow {
    const double* advected_x;
    const double* advected_y;
    double* gradient_x;
    double* gradient_y;
};

/// What the non-advective part does to a gradient (Saeki & Okamura 2007, eq. 11, with the cross
/// terms of two dimensions). `gained` is what the value gained beside advection, (u, v) the
/// velocity it was advected with.
void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, const TurnedRow& gradient);

/// A velocity component around a row: before the sub-step, after it, and what it gained.
struct ChangedStencil {
    Stencil before;
    Stencil after;
    Stencil gained;
};

/// The same of both velocities' gradients. Where `held`, they are at most twice the larger step of
/// the value toward a neighbour.
void turn_velocity_gradients(const ChangedStencil& u, const ChangedStencil& v, const SubStep& step,
                             bool held, int count, const TurnedRow& of_u, const TurnedRow& of_v);

/// The largest (|u| + √(g h)) / dx + (|v| + √(g h)) / dy of a row, 1/s; 0 where all is dry. Cells
/// whose values are not numbers are passed over.
double fastest(const double* depth, const Velocity& velocity, const SubStep& step, int count);

}  // namespace fumon::cip
