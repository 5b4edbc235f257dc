#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/block_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/samples/block_vectors.h"
#include "render/samples/cut_triangles.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::block_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;

/// x, y and nearness of as many corners as a vector of doubles has.
HWY_INLINE void place_some(const Placed& placed, const float* places, const float* heights,
                           std::int32_t* x, std::int32_t* y, float* nearness) {
    const Doubles d;
    const hn::Rebind<float, Doubles> floats;
    const hn::Rebind<std::int32_t, Doubles> integers;
    hn::Vec<decltype(floats)> read_east;
    hn::Vec<decltype(floats)> read_north;
    hn::LoadInterleaved2(floats, places, read_east, read_north);
    const auto east = hn::PromoteTo(d, read_east);
    const auto north = hn::PromoteTo(d, read_north);
    const auto height = hn::PromoteTo(d, hn::LoadU(floats, heights));
    const auto value = [&](const Linear& of) HWY_ATTR {
        return hn::Set(d, of.east) * east + hn::Set(d, of.north) * north +
               hn::Set(d, of.height) * height + hn::Set(d, of.constant);
    };
    const auto depth = value(placed.depth);
    const auto least = hn::Set(d, placed.least_depth);
    const auto before = hn::Ge(depth, least);
    const auto safe = hn::IfThenElse(before, depth, least);
    const auto half = hn::Set(d, 0.5);
    const auto at_x = hn::Floor(value(placed.x) / safe + half);
    const auto at_y = hn::Floor(value(placed.y) / safe + half);
    const auto farthest = hn::Set(d, farthest_place);
    const auto inside = hn::And(hn::Le(hn::Abs(at_x), farthest), hn::Le(hn::Abs(at_y), farthest));
    const auto has_place = hn::And(before, inside);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(has_place, at_x)), integers, x);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(has_place, at_y)), integers, y);
    hn::StoreU(hn::DemoteTo(floats, hn::IfThenElseZero(has_place, value(placed.nearness) / safe)),
               floats, nearness);
}

void place_corners(const Placed& placed, const float* places, const float* heights,
                   std::size_t count, std::int32_t* x, std::int32_t* y, float* nearness) {
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
    const std::size_t lanes = hn::Lanes(Doubles());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        place_some(placed, places + 2 * i, heights + i, x + i, y + i, nearness + i);
    if (i == count) return;
    float last_places[2 * most] = {};
    float last_heights[most] = {};
    std::int32_t last_x[most];
    std::int32_t last_y[most];
    float last_nearness[most];
    std::copy(places + 2 * i, places + 2 * count, last_places);
    std::copy(heights + i, heights + count, last_heights);
    place_some(placed, last_places, last_heights, last_x, last_y, last_nearness);
    for (std::size_t k = 0; i < count; ++i, ++k) {
        x[i] = last_x[k];
        y[i] = last_y[k];
        nearness[i] = last_nearness[k];
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::block_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::block_vectors {

HWY_EXPORT(place_corners);

void place_corners(const Placed& placed, const float* places, const float* heights,
                   std::size_t count, triangle_vectors::Corners& corners, std::size_t first) {
    HWY_DYNAMIC_DISPATCH(place_corners)
    (placed, places, heights, count, corners.x.data() + first, corners.y.data() + first,
     corners.nearness.data() + first);
}

}  // namespace fumon::block_vectors
#endif
