#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/view/tile_warp_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include "render/view/tile_warp-inl.h"
#include "render/view/tile_warp_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::tile_warp {
namespace HWY_NAMESPACE {

WarpedGround warp_at(const glm::dvec2& periods, double strength) {
    const hn::CappedTag<double, 1> d;
    const auto copies =
        warp_fields_at(d, hn::Set(d, periods.x), hn::Set(d, periods.y), hn::Set(d, strength));
    const auto number = [](auto value) HWY_ATTR { return hn::GetLane(value); };
    WarpedGround copy;
    copy.offset = {number(copies.aside_east.value), number(copies.aside_north.value)};
    copy.jacobian[0] = {1.0 + number(copies.aside_east.east), number(copies.aside_north.east)};
    copy.jacobian[1] = {number(copies.aside_east.north), 1.0 + number(copies.aside_north.north)};
    copy.height = number(copies.height.value);
    copy.height_gradient = {number(copies.height.east), number(copies.height.north)};
    return copy;
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::tile_warp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::tile_warp {

HWY_EXPORT(warp_at);

WarpedGround warp_at(const glm::dvec2& periods, double strength) {
    return HWY_DYNAMIC_DISPATCH(warp_at)(periods, strength);
}

}  // namespace fumon::tile_warp
#endif
