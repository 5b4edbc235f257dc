#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/ground/ground_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "render/ground/ground_vectors.h"
#include "render/view/tile_warp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::ground_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, samples_per_batch>;
using Floats = hn::Rebind<float, Doubles>;
using Integers = hn::Rebind<std::int32_t, Doubles>;

/// Two neighbouring cells, and how far a place lies from the first towards the second.
struct LinearTaps {
    hn::Vec<Integers> first;
    hn::Vec<Integers> second;
    hn::Vec<Floats> share;
};

HWY_INLINE LinearTaps linear_taps(hn::Vec<Doubles> periods, int count) {
    const Doubles d;
    const Integers integers;
    const auto cells = hn::Set(d, static_cast<double>(count));
    const auto position = (periods - hn::Trunc(periods)) * cells - hn::Set(d, 0.5);
    const auto within = hn::IfThenElse(hn::Lt(position, hn::Zero(d)), position + cells, position);
    // Within the bed whatever the place is.
    const auto first =
        hn::Max(hn::Min(hn::DemoteTo(integers, within), hn::Set(integers, std::int32_t{count} - 1)),
                hn::Zero(integers));
    const auto next = first + hn::Set(integers, std::int32_t{1});
    const auto second =
        hn::IfThenZeroElse(hn::Eq(next, hn::Set(integers, std::int32_t{count})), next);
    return {first, second, hn::DemoteTo(Floats(), within - hn::PromoteTo(d, first))};
}

/// Places in the maps of a bed in its plain, as GroundTiles::in_maps().
HWY_INLINE void wrap_to_maps(hn::Vec<Doubles>& east, hn::Vec<Doubles>& north) {
    const Doubles d;
    const auto whole_east = hn::Floor(east);
    const auto whole_north = hn::Floor(north);
    const auto is_own = hn::And(hn::Eq(whole_east, hn::Zero(d)), hn::Eq(whole_north, hn::Zero(d)));
    const auto aside = hn::IfThenZeroElse(is_own, hn::Set(d, 1.0));
    east = hn::Set(d, 0.5) * (east - whole_east + aside);
    north = north - whole_north;
}

void evaluate(const Heights& bed, const Eye& eye, const RaySamples& positions, int count,
              double* over, double* tangents) {
    const Doubles d;
    const Floats floats;
    const auto columns = hn::Set(Integers(), std::int32_t{bed.nx});
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
        const auto radius = hn::LoadU(d, positions.radii + i);
        auto eastward = hn::LoadU(d, positions.east + i);
        auto northward = hn::LoadU(d, positions.north + i);
        if (bed.tiles.plain) wrap_to_maps(eastward, northward);
        const LinearTaps x = linear_taps(eastward, bed.nx);
        const LinearTaps y = linear_taps(northward, bed.ny);
        const auto height = [&](hn::Vec<Integers> column, hn::Vec<Integers> row) HWY_ATTR {
            return hn::GatherIndex(floats, bed.values, row * columns + column);
        };
        const auto below = height(x.first, y.first);
        const auto above = height(x.first, y.second);
        const auto south = below + x.share * (height(x.second, y.first) - below);
        const auto north = above + x.share * (height(x.second, y.second) - above);
        auto z = hn::PromoteTo(d, south + y.share * (north - south));
        if (positions.raised != nullptr) {
            const auto mean = hn::Set(d, eye.mean);
            const auto raised = hn::LoadU(d, positions.raised + i);
            const auto unwarped = hn::Eq(raised, hn::Set(d, 1.0));
            z = hn::IfThenElse(unwarped, z, mean + raised * (z - mean));
        }
        const auto over_eye =
            z - radius * radius * hn::Set(d, eye.curvature) - hn::Set(d, eye.height);
        hn::StoreU(over_eye, d, over + i);
        hn::StoreU(over_eye / radius, d, tangents + i);
    }
}

void warp_along_ray(const WarpedRay& ray, const double* radii, int count, double* east,
                    double* north, double* height) {
    const Doubles d;
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
        const auto radius = hn::LoadU(d, radii + i);
        const auto copies = tile_warp::HWY_NAMESPACE::warp_fields_at(
            d, hn::Set(d, ray.east) + radius * hn::Set(d, ray.east_per_length),
            hn::Set(d, ray.north) + radius * hn::Set(d, ray.north_per_length),
            hn::Set(d, ray.strength));
        hn::StoreU(copies.aside_east.value, d, east + i);
        hn::StoreU(copies.aside_north.value, d, north + i);
        hn::StoreU(copies.height.value, d, height + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::ground_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::ground_vectors {

HWY_EXPORT(evaluate);
HWY_EXPORT(warp_along_ray);

void evaluate(const Heights& bed, const Eye& eye, const RaySamples& positions, int count,
              double* over, double* tangents) {
    HWY_DYNAMIC_DISPATCH(evaluate)(bed, eye, positions, count, over, tangents);
}

void warp_along_ray(const WarpedRay& ray, const double* radii, int count, double* east,
                    double* north, double* height) {
    HWY_DYNAMIC_DISPATCH(warp_along_ray)(ray, radii, count, east, north, height);
}

}  // namespace fumon::ground_vectors
#endif
