#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/cip_advection_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/cip_advection_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::cip {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Where the water of some cells comes from, and how far.
template <class D>
struct Upwind {
    using V = hn::Vec<D>;
    hn::Mask<D> west;
    hn::Mask<D> south;
    V sign_x;  ///< only the sign bit: set where from the west
    V sign_y;
    V a;  ///< in cells
    V b;

    HWY_INLINE Upwind(D d, V u, V v, double per_x, double per_y)
        : west(hn::Gt(u, hn::Zero(d))), south(hn::Gt(v, hn::Zero(d))) {
        const V sign = hn::SignBit(d);
        sign_x = hn::IfThenElseZero(west, sign);
        sign_y = hn::IfThenElseZero(south, sign);
        a = hn::Xor(u, hn::AndNot(sign_x, sign)) * hn::Set(d, per_x);
        b = hn::Xor(v, hn::AndNot(sign_y, sign)) * hn::Set(d, per_y);
    }
};

template <class D, bool held>
HWY_INLINE void advect(D d, std::size_t x, const AdvectedStencil& before, const Upwind<D>& from,
                       const AdvectedRow& after) {
    using V = hn::Vec<D>;
    const auto load = [&](const double* row) HWY_ATTR { return hn::LoadU(d, row + x); };
    const auto along_x = [&](const double* row) HWY_ATTR {
        return hn::IfThenElse(from.west, hn::LoadU(d, row + x - 1), hn::LoadU(d, row + x + 1));
    };
    const auto along_y = [&](const Stencil& rows) HWY_ATTR {
        return hn::IfThenElse(from.south, load(rows.south), load(rows.north));
    };
    const auto turned_x = [&](V p) HWY_ATTR { return hn::Xor(p, from.sign_x); };
    const auto turned_y = [&](V q) HWY_ATTR { return hn::Xor(q, from.sign_y); };
    const V two = hn::Set(d, 2.0);
    const V three = hn::Set(d, 3.0);
    const V a = from.a;
    const V b = from.b;
    const V f0 = load(before.value.here);
    const V f1 = along_x(before.value.here);
    const V f2 = along_y(before.value);
    const V f3 =
        hn::IfThenElse(from.south, along_x(before.value.south), along_x(before.value.north));
    const V p0 = turned_x(load(before.gradient_x.here));
    const V p1 = turned_x(along_x(before.gradient_x.here));
    const V p2 = turned_x(along_y(before.gradient_x));
    const V q0 = turned_y(load(before.gradient_y.here));
    const V q1 = turned_y(along_x(before.gradient_y.here));
    const V q2 = turned_y(along_y(before.gradient_y));
    // CIP, type A (Yabe et al. 1991): in the upwind cell f is the cubic Σ c_mn a^m b^n, m + n ≤ 3,
    // of the values at its four corners and the gradients at three of them, taken at (a, b), where
    // the water comes from; c_10 = p0 and c_01 = q0 are the gradients here. Gradients are its
    // derivatives.
    const V rise_x = f1 - f0;
    const V rise_y = f2 - f0;
    const V c30 = (p0 + p1) - two * rise_x;
    const V c20 = (three * rise_x - two * p0) - p1;
    const V c03 = (q0 + q2) - two * rise_y;
    const V c02 = (three * rise_y - two * q0) - q2;
    const V twist = (f3 - f1) - rise_y;
    const V c12 = twist - (q1 - q0);
    const V c21 = twist - (p2 - p0);
    const V c11 = (q1 - q0) - c21;
    const V ac21 = a * c21;
    const V bc12 = b * c12;
    V value = f0 + a * ((p0 + a * (c20 + a * c30)) + b * ((c11 + ac21) + bc12)) +
              b * (q0 + b * (c02 + b * c03));
    if constexpr (held) {
        const V low = smaller(smaller(f0, f1), smaller(f2, f3));
        const V high = larger(larger(f0, f1), larger(f2, f3));
        value = smaller(larger(value, low), high);
    }
    hn::StoreU(value, d, after.value + x);
    const V gradient_x =
        (p0 + a * (two * c20 + three * a * c30)) + b * ((c11 + two * a * c21) + bc12);
    const V gradient_y =
        (q0 + b * (two * c02 + three * b * c03)) + a * ((c11 + ac21) + two * b * c12);
    hn::StoreU(turned_x(gradient_x), d, after.gradient_x + x);
    hn::StoreU(turned_y(gradient_y), d, after.gradient_y + x);
}

struct Advect {
    AdvectedStencil before;
    Velocity by;
    double per_x;
    double per_y;
    AdvectedRow after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const Upwind<D> from(d, hn::LoadU(d, by.u + x), hn::LoadU(d, by.v + x), per_x, per_y);
        advect<D, false>(d, x, before, from, after);
    }
};

template <bool held>
struct AdvectVelocities {
    AdvectedStencil u;
    AdvectedStencil v;
    double per_x;
    double per_y;
    AdvectedRow u_after;
    AdvectedRow v_after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const Upwind<D> from(d, hn::LoadU(d, u.value.here + x), hn::LoadU(d, v.value.here + x),
                             per_x, per_y);
        advect<D, held>(d, x, u, from, u_after);
        advect<D, held>(d, x, v, from, v_after);
    }
};

void advect_row(const AdvectedStencil& before, const Velocity& by, const SubStep& step, int count,
                const AdvectedRow& after) {
    for_each_vector_overlapping(count,
                                Advect{before, by, step.dt / step.dx, step.dt / step.dy, after});
}

void advect_velocities(const AdvectedStencil& u, const AdvectedStencil& v, const SubStep& step,
                       bool held, int count, const AdvectedRow& u_after,
                       const AdvectedRow& v_after) {
    const double per_x = step.dt / step.dx;
    const double per_y = step.dt / step.dy;
    if (held) {
        for_each_vector_overlapping(count,
                                    AdvectVelocities<true>{u, v, per_x, per_y, u_after, v_after});
    } else {
        for_each_vector_overlapping(count,
                                    AdvectVelocities<false>{u, v, per_x, per_y, u_after, v_after});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::cip
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::cip {

HWY_EXPORT(advect_row);
HWY_EXPORT(advect_velocities);

void advect_row(const AdvectedStencil& before, const Velocity& by, const SubStep& step, int count,
                const AdvectedRow& after) {
    HWY_DYNAMIC_DISPATCH(advect_row)(before, by, step, count, after);
}

void advect_velocities(const AdvectedStencil& u, const AdvectedStencil& v, const SubStep& step,
                       bool held, int count, const AdvectedRow& u_after,
                       const AdvectedRow& v_after) {
    HWY_DYNAMIC_DISPATCH(advect_velocities)(u, v, step, held, count, u_after, v_after);
}

}  // namespace fumon::cip
#endif
