#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/mean_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/mean_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

template <class V>
HWY_INLINE V within(V value, V most) {
    return larger(smaller(value, most), constant<V>(0.0) - most);
}

struct MeansToFaces {
    CellRow b;
    CellRow c;
    CellRow f;
    HalfSlopes s;
    MeanRow out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + k); };
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0);
        const V two = hn::Set(d, 2.0);
        const V twelfth = hn::Set(d, 1.0 / 12.0);
        const V depth = load(c.depth);
        const V depth_b = load(b.depth);
        const V depth_f = load(f.depth);
        const V depth_back = depth - depth_b;
        const V depth_forward = depth_f - depth;
        const V surface = load(c.surface);
        const V surface_back = surface - load(b.surface);
        const V surface_forward = load(f.surface) - surface;
        const V bed_step =
            larger(hn::Abs(surface_back - depth_back), hn::Abs(surface_forward - depth_forward));
        const V shallowest = smaller(smaller(depth_b, depth_f), depth);
        const auto deep = hn::And(hn::Gt(shallowest, bed_step),
                                  hn::Gt(load(b.inside) * load(c.inside) * load(f.inside), zero));
        const auto second_difference = [&](V back, V forward) HWY_ATTR {
            return hn::IfThenElseZero(
                deep, within(forward - back, two * smaller(hn::Abs(back), hn::Abs(forward))));
        };
        // A parabola of these means has h ± s + (h_back − 2 h + h_forward)/12 at the faces.
        const V depth_bend = second_difference(depth_back, depth_forward);
        const V surface_bend = twelfth * second_difference(surface_back, surface_forward);
        hn::StoreU(depth + twelfth * depth_bend, d, out.depth + k);
        hn::StoreU(surface + surface_bend, d, out.surface + k);

        // The mean of h u over that of h is u + (∂h/∂x ∂u/∂x) Δx²/(12 h): taken off here.
        const V half_rise = load(s.depth);
        const auto lean = [&](V rise, V over) HWY_ATTR {
            return hn::IfThenElseZero(deep,
                                      within(rise / larger(over, hn::Set(d, dry_depth)), two));
        };
        const V lean_back = lean(two * half_rise - depth_bend, depth_b);
        const V lean_forward = lean(two * half_rise + depth_bend, depth_f);
        const V own_share = one / (one + hn::Set(d, 1.0 / 24.0) * (lean_forward - lean_back));
        const V half_lean = lean(half_rise, depth);
        const auto put = [&](const double* carried, double* half_slope, double* at_faces) HWY_ATTR {
            const V slope = own_share * load(half_slope);
            hn::StoreU(slope, d, half_slope + k);
            hn::StoreU(load(carried) - hn::Set(d, 1.0 / 3.0) * (half_lean * slope), d,
                       at_faces + k);
        };
        put(c.normal, s.normal, out.normal);
        put(c.transverse, s.transverse, out.transverse);
        hn::StoreU(load(s.surface) + half_lean * surface_bend, d, out.slope + k);
    }
};

void means_to_faces(const CellRow& back, const CellRow& here, const CellRow& forward,
                    const HalfSlopes& slopes, const MeanRow& out, int count) {
    for_each_vector(count, MeansToFaces{back, here, forward, slopes, out});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(means_to_faces);

void means_to_faces(const CellRow& back, const CellRow& here, const CellRow& forward,
                    const HalfSlopes& slopes, const MeanRow& out, int count) {
    HWY_DYNAMIC_DISPATCH(means_to_faces)(back, here, forward, slopes, out, count);
}

}  // namespace fumon::finite_volume
#endif
