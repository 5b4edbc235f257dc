#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/cip_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/cip_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::cip {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Water shallower than this, in metres, stands still: it is less than a molecule.
constexpr double dry_depth = 1e-10;

/// What the forces depend on.
struct Forces {
    Stencil depth;
    Stencil bed;
    double push_x;  ///< velocity gained in a sub-step per metre of rise over two cells, 1/s
    double push_y;
    double pull;  ///< velocity gained in a sub-step, m/s
    double drag;

    Forces(const Stencil& depth_of, const Stencil& bed_of, const SubStep& step)
        : depth(depth_of),
          bed(bed_of),
          push_x(-0.5 * step.dt * step.gravity / step.dx),
          push_y(-0.5 * step.dt * step.gravity / step.dy),
          pull(step.dt * step.pull),
          drag(step.dt * step.friction) {}
};

template <class D, class V>
HWY_INLINE void store_accelerated(D d, std::size_t x, V u, V v, V in_u, V in_v,
                                  const Accelerated& after) {
    hn::StoreU(u, d, after.u + x);
    hn::StoreU(v, d, after.v + x);
    hn::StoreU(u - in_u, d, after.gained_u + x);
    hn::StoreU(v - in_v, d, after.gained_v + x);
}

/// The rise of the surface over two cells, along x and along y.
template <class D>
HWY_INLINE auto central_rise_x(D d, std::size_t x, const Forces& by) {
    const double* h = by.depth.here + x;
    const double* z = by.bed.here + x;
    return (hn::LoadU(d, h + 1) - hn::LoadU(d, h - 1)) +
           (hn::LoadU(d, z + 1) - hn::LoadU(d, z - 1));
}

template <class D>
HWY_INLINE auto central_rise_y(D d, std::size_t x, const Forces& by) {
    return (hn::LoadU(d, by.depth.north + x) - hn::LoadU(d, by.depth.south + x)) +
           (hn::LoadU(d, by.bed.north + x) - hn::LoadU(d, by.bed.south + x));
}

/// Saeki & Okamura (2007), eq. 10, after the advection, which leaves u*; friction half implicit:
/// u = (u* − dt g ∂(h + z)/∂x) / (1 + dt C_f |u*| / h), v likewise with the plane's −dt g·slope.
struct Accelerate {
    Forces by;
    Velocity advected;
    Accelerated after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V in_u = hn::LoadU(d, advected.u + x);
        const V in_v = hn::LoadU(d, advected.v + x);
        const V free_u = in_u + hn::Set(d, by.push_x) * central_rise_x(d, x, by);
        const V free_v =
            (in_v + hn::Set(d, by.pull)) + hn::Set(d, by.push_y) * central_rise_y(d, x, by);
        const V speed = hn::Sqrt(in_u * in_u + in_v * in_v);
        const V h = hn::LoadU(d, by.depth.here + x);
        const auto wet = hn::Gt(h, hn::Set(d, dry_depth));
        const V kept = hn::IfThenElseZero(wet, h) /
                       (hn::IfThenElse(wet, h, hn::Set(d, 1.0)) + hn::Set(d, by.drag) * speed);
        store_accelerated(d, x, kept * free_u, kept * free_v, in_u, in_v, after);
    }
};

/// The rise of the surface from one neighbour to the other, from the rises toward either.
template <class V>
HWY_INLINE V limited_rise(V back, V depth_back, V forward, V depth_forward) {
    const V to_back = smaller(back, larger(depth_back, hn::Neg(forward)));
    const V to_forward = smaller(forward, larger(depth_forward, hn::Neg(back)));
    return to_forward - to_back;
}

/// The same with limited rises; friction implicit, u (1 + dt C_f |u| / h) = u* − dt g ∂(h + z)/∂x,
/// whose solution is the right side, of size s, times 2 / (1 + √(1 + 4 dt C_f s / h)).
struct AccelerateSteep {
    Forces by;
    double plane;  ///< its rise from a row to the next, m
    Velocity advected;
    Accelerated after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V one = hn::Set(d, 1.0);
        const V h = hn::LoadU(d, by.depth.here + x);
        const V z = hn::LoadU(d, by.bed.here + x);
        const V h_west = hn::LoadU(d, by.depth.here + x - 1);
        const V h_east = hn::LoadU(d, by.depth.here + x + 1);
        const V h_south = hn::LoadU(d, by.depth.south + x);
        const V h_north = hn::LoadU(d, by.depth.north + x);
        const auto toward = [&](V depth, const double* bed)
                                HWY_ATTR { return (depth - h) + (hn::LoadU(d, bed + x) - z); };
        const V west = toward(h_west, by.bed.here - 1);
        const V east = toward(h_east, by.bed.here + 1);
        const V south = toward(h_south, by.bed.south) - hn::Set(d, plane);
        const V north = toward(h_north, by.bed.north) + hn::Set(d, plane);
        const V in_u = hn::LoadU(d, advected.u + x);
        const V in_v = hn::LoadU(d, advected.v + x);
        const V free_u = in_u + hn::Set(d, by.push_x) * limited_rise(west, h_west, east, h_east);
        const V free_v =
            in_v + hn::Set(d, by.push_y) * limited_rise(south, h_south, north, h_north);
        const V speed = hn::Sqrt(free_u * free_u + free_v * free_v);
        const auto wet = hn::Gt(h, hn::Set(d, dry_depth));
        const V per_depth = one / hn::IfThenElse(wet, h, one);
        const V drag = hn::Set(d, 4.0 * by.drag);
        const V kept = hn::IfThenElseZero(
            wet, hn::Set(d, 2.0) / (one + hn::Sqrt(one + drag * (speed * per_depth))));
        store_accelerated(d, x, kept * free_u, kept * free_v, in_u, in_v, after);
    }
};

/// Eq. 10 with all forces before the sub-step: u = u* − dt (g ∂(h + z)/∂x + C_f |u| u / h).
struct AccelerateAsPublished {
    Forces by;
    Velocity before;
    Velocity advected;
    Accelerated after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V u = hn::LoadU(d, before.u + x);
        const V v = hn::LoadU(d, before.v + x);
        const V speed = hn::Sqrt(u * u + v * v);
        const V lost = hn::Set(d, by.drag) * speed / hn::LoadU(d, by.depth.here + x);
        const V gained_u = hn::Set(d, by.push_x) * central_rise_x(d, x, by) - lost * u;
        const V gained_v =
            (hn::Set(d, by.pull) + hn::Set(d, by.push_y) * central_rise_y(d, x, by)) - lost * v;
        hn::StoreU(hn::LoadU(d, advected.u + x) + gained_u, d, after.u + x);
        hn::StoreU(hn::LoadU(d, advected.v + x) + gained_v, d, after.v + x);
        hn::StoreU(gained_u, d, after.gained_u + x);
        hn::StoreU(gained_v, d, after.gained_v + x);
    }
};

/// The velocity's differences over two cells.
template <class D>
struct Shear {
    using V = hn::Vec<D>;
    V u_x, u_y, v_x, v_y;
    V half_x, half_y;  ///< dt/2dx, dt/2dy

    HWY_INLINE Shear(D d, std::size_t x, const Stencil& u, const Stencil& v, double per_x,
                     double per_y)
        : u_x(hn::LoadU(d, u.here + x + 1) - hn::LoadU(d, u.here + x - 1)),
          u_y(hn::LoadU(d, u.north + x) - hn::LoadU(d, u.south + x)),
          v_x(hn::LoadU(d, v.here + x + 1) - hn::LoadU(d, v.here + x - 1)),
          v_y(hn::LoadU(d, v.north + x) - hn::LoadU(d, v.south + x)),
          half_x(hn::Set(d, per_x)),
          half_y(hn::Set(d, per_y)) {}
};

/// Not beyond ±most.
template <class V>
HWY_INLINE V within(V value, V most) {
    return smaller(larger(value, hn::Neg(most)), most);
}

/// Saeki & Okamura (2007), eq. 11: with what f gained beside advection as G, f_x ← f_x + ∂G/∂x − dt
/// (∂u/∂x f_x + ∂v/∂x f_y), and f_y likewise, all by central differences.
template <bool held, class D>
HWY_INLINE void turn_one(D d, std::size_t x, const Shear<D>& by, const Stencil& gained,
                         const Stencil& value, const TurnedRow& gradient) {
    using V = hn::Vec<D>;
    const V half = hn::Set(d, 0.5);
    const V fx = hn::LoadU(d, gradient.advected_x + x);
    const V fy = hn::LoadU(d, gradient.advected_y + x);
    const V along = by.half_x * fx;
    const V across = by.half_y * fy;
    const V rise_x = hn::LoadU(d, gained.here + x + 1) - hn::LoadU(d, gained.here + x - 1);
    const V rise_y = hn::LoadU(d, gained.north + x) - hn::LoadU(d, gained.south + x);
    V turned_x = fx + (half * rise_x - (by.u_x * along + by.v_x * across));
    V turned_y = fy + (half * rise_y - (by.u_y * along + by.v_y * across));
    if constexpr (held) {
        const V f = hn::LoadU(d, value.here + x);
        const auto step_to = [&](const double* side)
                                 HWY_ATTR { return hn::Abs(hn::LoadU(d, side + x) - f); };
        const V two = hn::Set(d, 2.0);
        turned_x = within(turned_x, two * larger(step_to(value.here + 1), step_to(value.here - 1)));
        turned_y = within(turned_y, two * larger(step_to(value.north), step_to(value.south)));
    }
    hn::StoreU(turned_x, d, gradient.gradient_x + x);
    hn::StoreU(turned_y, d, gradient.gradient_y + x);
}

struct TurnGradient {
    Stencil gained;
    Stencil u;
    Stencil v;
    double half_x;
    double half_y;
    TurnedRow gradient;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        turn_one<false>(d, x, Shear<D>(d, x, u, v, half_x, half_y), gained, gained, gradient);
    }
};

template <bool held>
struct TurnVelocityGradients {
    ChangedStencil u;
    ChangedStencil v;
    double half_x;
    double half_y;
    TurnedRow of_u;
    TurnedRow of_v;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const Shear<D> by(d, x, u.before, v.before, half_x, half_y);
        turn_one<held>(d, x, by, u.gained, u.after, of_u);
        turn_one<held>(d, x, by, v.gained, v.after, of_v);
    }
};

struct Rates {
    const double* depth;
    Velocity velocity;
    double per_x;
    double per_y;
    double gravity;

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, std::size_t x) const {
        const auto h = greater(hn::LoadU(d, depth + x), hn::Zero(d));
        const auto along_x = hn::Set(d, per_x) * hn::Abs(hn::LoadU(d, velocity.u + x));
        const auto along_y = hn::Set(d, per_y) * hn::Abs(hn::LoadU(d, velocity.v + x));
        const auto wave = hn::Sqrt(hn::Set(d, gravity) * h);
        return (along_x + along_y) + hn::Set(d, per_x + per_y) * wave;
    }
};

void accelerate_row(const Stencil& depth, const Stencil& bed, const SubStep& step,
                    const Velocity& advected, int count, const Accelerated& after) {
    for_each_vector_overlapping(count, Accelerate{Forces(depth, bed, step), advected, after});
}

void accelerate_row_steep(const Stencil& depth, const Stencil& bed, const SubStep& step,
                          const Velocity& advected, int count, const Accelerated& after) {
    const double plane = -step.pull * step.dy / step.gravity;
    for_each_vector_overlapping(count,
                                AccelerateSteep{Forces(depth, bed, step), plane, advected, after});
}

void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const Velocity& before,
                                 const SubStep& step, const Velocity& advected, int count,
                                 const Accelerated& after) {
    for_each_vector_overlapping(
        count, AccelerateAsPublished{Forces(depth, bed, step), before, advected, after});
}

void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, const TurnedRow& gradient) {
    for_each_vector(count, TurnGradient{gained, u, v, 0.5 * step.dt / step.dx,
                                        0.5 * step.dt / step.dy, gradient});
}

void turn_velocity_gradients(const ChangedStencil& u, const ChangedStencil& v, const SubStep& step,
                             bool held, int count, const TurnedRow& of_u, const TurnedRow& of_v) {
    const double half_x = 0.5 * step.dt / step.dx;
    const double half_y = 0.5 * step.dt / step.dy;
    if (held) {
        for_each_vector_overlapping(count,
                                    TurnVelocityGradients<true>{u, v, half_x, half_y, of_u, of_v});
    } else {
        for_each_vector_overlapping(count,
                                    TurnVelocityGradients<false>{u, v, half_x, half_y, of_u, of_v});
    }
}

double fastest(const double* depth, const Velocity& velocity, const SubStep& step, int count) {
    return largest_of_row(count,
                          Rates{depth, velocity, 1.0 / step.dx, 1.0 / step.dy, step.gravity});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::cip
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::cip {

HWY_EXPORT(accelerate_row);
HWY_EXPORT(accelerate_row_steep);
HWY_EXPORT(accelerate_row_as_published);
HWY_EXPORT(turn_gradient_row);
HWY_EXPORT(turn_velocity_gradients);
HWY_EXPORT(fastest);

void accelerate_row(const Stencil& depth, const Stencil& bed, const SubStep& step,
                    const Velocity& advected, int count, const Accelerated& after) {
    HWY_DYNAMIC_DISPATCH(accelerate_row)(depth, bed, step, advected, count, after);
}

void accelerate_row_steep(const Stencil& depth, const Stencil& bed, const SubStep& step,
                          const Velocity& advected, int count, const Accelerated& after) {
    HWY_DYNAMIC_DISPATCH(accelerate_row_steep)(depth, bed, step, advected, count, after);
}

void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const Velocity& before,
                                 const SubStep& step, const Velocity& advected, int count,
                                 const Accelerated& after) {
    HWY_DYNAMIC_DISPATCH(accelerate_row_as_published)
    (depth, bed, before, step, advected, count, after);
}

void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, const TurnedRow& gradient) {
    HWY_DYNAMIC_DISPATCH(turn_gradient_row)(gained, u, v, step, count, gradient);
}

void turn_velocity_gradients(const ChangedStencil& u, const ChangedStencil& v, const SubStep& step,
                             bool held, int count, const TurnedRow& of_u, const TurnedRow& of_v) {
    HWY_DYNAMIC_DISPATCH(turn_velocity_gradients)(u, v, step, held, count, of_u, of_v);
}

double fastest(const double* depth, const Velocity& velocity, const SubStep& step, int count) {
    return HWY_DYNAMIC_DISPATCH(fastest)(depth, velocity, step, count);
}

}  // namespace fumon::cip
#endif
