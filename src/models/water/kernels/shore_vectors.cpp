#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/shore_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/shore_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

constexpr double dry_depth = 1e-9;      // m, as for the fluxes
constexpr double film_share = 0.3;      // of a cell's depth: what is thinner beyond it is a film
constexpr double depth_floor = 1e-300;  // m

/// How the depth ends in a cell of mean depth `thin` beside one of depth `inner`.
template <class V>
struct EndOfWater {
    V share;  ///< of the cell that is wet
    V drop;   ///< of the depth over a cell
    V lift;   ///< of bed plus mean depth over the water's plane
};

template <class V>
HWY_INLINE EndOfWater<V> end_of_water(V inner, V thin) {
    const V one = constant<V>(1.0);
    const V half = constant<V>(0.5);
    const V zero = constant<V>(0.0);
    const V ratio = thin / larger(inner, constant<V>(depth_floor));
    const V share = ratio + hn::Sqrt(ratio * ratio + ratio);
    const V drop = hn::IfThenElse(hn::Lt(share, one), inner / (share + half), inner - thin);
    const V dry_share = larger(one - share, zero);
    return {share, drop, half * drop * (dry_share * dry_share)};
}

template <class V>
HWY_INLINE V minmod_half(V back, V forward) {
    const V zero = constant<V>(0.0);
    const V rising = larger(smaller(back, forward), zero);
    const V falling = smaller(larger(back, forward), zero);
    return constant<V>(0.5) * (rising + falling);
}

struct ShoreHalfSlopes {
    CellRow b;
    CellRow c;
    CellRow f;
    double gravity;
    HalfSlopes out;

    template <class D>
    HWY_INLINE hn::Vec<D> velocity_head(D d, const CellRow& cell, std::size_t k) const {
        const auto u = hn::LoadU(d, cell.normal + k);
        const auto v = hn::LoadU(d, cell.transverse + k);
        return (u * u + v * v) * hn::Set(d, 0.5 / gravity);
    }

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V half = hn::Set(d, 0.5);
        const V dry = hn::Set(d, dry_depth);
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + k); };
        const auto inside = hn::Gt(load(b.inside) * load(c.inside) * load(f.inside), zero);
        const V depth = load(c.depth);
        const V depth_b = load(b.depth);
        const V depth_f = load(f.depth);
        const V surface_back = load(c.surface) - load(b.surface);
        const V surface_forward = load(f.surface) - load(c.surface);
        const V rise_b = (depth - depth_b) - surface_back;  // of the bed, toward the back
        const V rise_f = surface_forward - (depth_f - depth);
        const auto is_wet = hn::And(inside, hn::Gt(depth, dry));

        const V film = larger(hn::Set(d, film_share) * depth, dry);
        const auto is_shore = [&](V depth_beyond, V rise_beyond, V depth_inner,
                                  V rise_inner) HWY_ATTR {
            return hn::And(hn::And(hn::Le(depth_beyond, film), hn::Gt(rise_beyond, depth)),
                           hn::And(hn::Gt(depth_inner, depth), hn::Le(rise_inner, zero)));
        };
        const auto shore_ahead = is_shore(depth_f, rise_f, depth_b, rise_b);
        const auto shore_behind = is_shore(depth_b, rise_b, depth_f, rise_f);
        const auto at_shore = hn::And(is_wet, hn::Or(shore_ahead, shore_behind));
        const EndOfWater<V> end =
            end_of_water(hn::IfThenElse(shore_ahead, depth_b, depth_f), depth);
        const V fall = hn::IfThenElse(hn::Lt(end.share, hn::Set(d, 1.0)),
                                      end.drop * end.share - depth, half * end.drop);
        const V lift = smaller(end.lift, velocity_head(d, c, k));
        const V depth_at_shore = hn::IfThenElse(shore_ahead, zero - fall, fall);
        const V surface_at_shore =
            half * hn::IfThenElse(shore_ahead, surface_back - lift, surface_forward + lift);

        // Beside a cell in which the water ends.
        const V shallowest = smaller(smaller(depth_b, depth_f), depth);
        const auto is_shallow = hn::Le(shallowest, larger(hn::Abs(rise_b), hn::Abs(rise_f)));
        const auto ends = [&](V thin, V rise) HWY_ATTR {
            return hn::And(hn::And(hn::Gt(thin, dry), hn::Gt(rise, zero)),
                           hn::Lt(thin * hn::Set(d, 3.0), depth));
        };
        const auto ends_f = ends(depth_f, rise_f);
        const auto ends_b = ends(depth_b, rise_b);
        const EndOfWater<V> end_f = end_of_water(depth, depth_f);
        const EndOfWater<V> end_b = end_of_water(depth, depth_b);
        const V lift_f = hn::IfThenElseZero(ends_f, smaller(end_f.lift, velocity_head(d, f, k)));
        const V lift_b = hn::IfThenElseZero(ends_b, smaller(end_b.lift, velocity_head(d, b, k)));
        const V depth_beside =
            minmod_half(hn::IfThenElse(ends_b, end_b.drop, depth - depth_b),
                        hn::IfThenElse(ends_f, zero - end_f.drop, depth_f - depth));
        const V surface_beside = minmod_half(surface_back + lift_b, surface_forward - lift_f);
        const auto beside = hn::And(hn::And(inside, is_shallow), hn::Or(ends_f, ends_b));

        const auto is_dry = hn::And(inside, hn::Le(depth, dry));
        const V bed = minmod_half(zero - rise_b, rise_f);
        const auto chosen = [&](V limited, V at_end, V next_to, V on_dry) HWY_ATTR {
            const V wet =
                hn::IfThenElse(at_shore, at_end, hn::IfThenElse(beside, next_to, limited));
            return hn::IfThenElse(is_dry, on_dry, wet);
        };
        hn::StoreU(chosen(load(out.depth), depth_at_shore, depth_beside, zero), d, out.depth + k);
        hn::StoreU(chosen(load(out.surface), surface_at_shore, surface_beside, bed), d,
                   out.surface + k);
    }
};

void shore_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                       double gravity, const HalfSlopes& out, int count) {
    for_each_vector_overlapping(count, ShoreHalfSlopes{back, here, forward, gravity, out});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(shore_half_slopes);

void shore_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                       double gravity, const HalfSlopes& out, int count) {
    HWY_DYNAMIC_DISPATCH(shore_half_slopes)(back, here, forward, gravity, out, count);
}

}  // namespace fumon::finite_volume
#endif
