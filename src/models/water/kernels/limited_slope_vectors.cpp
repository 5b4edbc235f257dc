#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/limited_slope_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/limited_slope_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Van Leer's (1977) limited slope, halved: minmod(θ/2 · back, (back + forward)/4, θ/2 · forward).
/// `bound`: half of the steepest slope over the smaller one-sided difference, from ½ (minmod, with
/// which the values of two cells at their face keep their order) to 1 (monotonised central).
template <class V>
HWY_INLINE V half_slope(V back, V forward, V bound, V quarter, V zero) {
    const V middle = quarter * (back + forward);
    const V rising = smaller(bound * smaller(back, forward), middle);
    const V falling = larger(bound * larger(back, forward), middle);
    return larger(rising, zero) + smaller(falling, zero);
}

/// The same, but past the limit by what `small` has over the larger of the two differences, so that
/// small ones are not limited and large ones are as if there were no such allowance.
template <class V>
HWY_INLINE V half_slope(V back, V forward, V bound, V quarter, V zero, V small) {
    const V free = larger(small - larger(hn::Abs(back), hn::Abs(forward)), zero);
    const V middle = quarter * (back + forward);
    const V highest = larger(bound * smaller(back, forward), zero) + free;
    const V lowest = smaller(bound * larger(back, forward), zero) - free;
    return larger(smaller(middle, highest), lowest);
}

/// Water thinner than so many of the bed's steps is a shore's.
constexpr double shore_steps = 2.0;

/// With the bed's slopes where `of_bed`; past the limit where `tolerant`.
template <bool of_bed, bool tolerant, bool even_shores>
struct LimitedHalfSlopes {
    CellRow b;
    CellRow c;
    CellRow f;
    SlopeLimits limits;
    HalfSlopes out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const V half = hn::Set(d, 0.5);
        const V quarter = hn::Set(d, 0.25);
        const V zero = hn::Zero(d);
        const V inside = hn::LoadU(d, c.inside + k);
        const V with_back = hn::LoadU(d, b.inside + k) * inside;
        const V with_forward = hn::LoadU(d, f.inside + k) * inside;
        const V depth = hn::LoadU(d, c.depth + k);
        const V depth_b = hn::LoadU(d, b.depth + k);
        const V depth_f = hn::LoadU(d, f.depth + k);
        const V surface = hn::LoadU(d, c.surface + k);
        const V depth_back = (depth - depth_b) * with_back;
        const V depth_forward = (depth_f - depth) * with_forward;
        const V surface_back = (surface - hn::LoadU(d, b.surface + k)) * with_back;
        const V surface_forward = (hn::LoadU(d, f.surface + k) - surface) * with_forward;
        const V shallowest = smaller(smaller(depth_b, depth_f), depth);
        const V bed_back = surface_back - depth_back;
        const V bed_forward = surface_forward - depth_forward;
        const V bed_step = larger(hn::Abs(bed_back), hn::Abs(bed_forward));
        const auto deep = hn::Gt(shallowest, bed_step);
        const V steepest = hn::Set(d, 0.5 * limits.steepness);
        const V bound = hn::IfThenElse(deep, steepest, half);
        V small_rise = zero;
        V small_speed = zero;
        if constexpr (tolerant) {
            const V open = hn::IfThenElseZero(deep, with_back * with_forward);
            small_rise = hn::Set(d, limits.tolerance) * depth * open;
            small_speed =
                hn::Set(d, limits.tolerance) * open * hn::Sqrt(hn::Set(d, limits.gravity) * depth);
        }
        const auto sloped = [&](V back, V forward, V at_most, V small) HWY_ATTR {
            if constexpr (tolerant) {
                return half_slope(back, forward, at_most, quarter, zero, small);
            } else {
                return half_slope(back, forward, at_most, quarter, zero);
            }
        };
        const auto limited = [&](const double* back, const double* here,
                                 const double* forward) HWY_ATTR {
            const V middle = hn::LoadU(d, here + k);
            return sloped((middle - hn::LoadU(d, back + k)) * with_back,
                          (hn::LoadU(d, forward + k) - middle) * with_forward, steepest,
                          small_speed);
        };
        V normal = limited(b.normal, c.normal, f.normal);
        V transverse = limited(b.transverse, c.transverse, f.transverse);
        if constexpr (even_shores) {
            const auto off_shore = hn::Gt(shallowest, hn::Set(d, shore_steps) * bed_step);
            normal = hn::IfThenElseZero(off_shore, normal);
            transverse = hn::IfThenElseZero(off_shore, transverse);
        }
        hn::StoreU(sloped(depth_back, depth_forward, bound, small_rise), d, out.depth + k);
        hn::StoreU(sloped(surface_back, surface_forward, bound, small_rise), d, out.surface + k);
        hn::StoreU(normal, d, out.normal + k);
        hn::StoreU(transverse, d, out.transverse + k);
        if constexpr (of_bed) {  // minmod
            const V rising = larger(smaller(bed_back, bed_forward), zero);
            const V falling = smaller(larger(bed_back, bed_forward), zero);
            hn::StoreU(half * (rising + falling), d, out.bed + k);
        }
    }
};

template <bool tolerant, bool even_shores>
HWY_INLINE void compute_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                               const SlopeLimits& limits, const HalfSlopes& out, int count) {
    if (out.bed != nullptr) {
        for_each_vector_overlapping(count, LimitedHalfSlopes<true, tolerant, even_shores>{
                                               back, here, forward, limits, out});
    } else {
        for_each_vector_overlapping(count, LimitedHalfSlopes<false, tolerant, even_shores>{
                                               back, here, forward, limits, out});
    }
}

void limited_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                         const SlopeLimits& limits, const HalfSlopes& out, int count) {
    if (limits.tolerance > 0.0) {
        limits.even_shores ? compute_slopes<true, true>(back, here, forward, limits, out, count)
                           : compute_slopes<true, false>(back, here, forward, limits, out, count);
    } else {
        limits.even_shores ? compute_slopes<false, true>(back, here, forward, limits, out, count)
                           : compute_slopes<false, false>(back, here, forward, limits, out, count);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(limited_half_slopes);

void limited_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                         const SlopeLimits& limits, const HalfSlopes& out, int count) {
    HWY_DYNAMIC_DISPATCH(limited_half_slopes)(back, here, forward, limits, out, count);
}

}  // namespace fumon::finite_volume
#endif
