#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/view/far_copies_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include "render/view/far_copies-inl.h"
#include "render/view/far_copies_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::far_copies {
namespace HWY_NAMESPACE {

GroundCopy copy_at(const glm::dvec2& periods, double strength) {
    const hn::CappedTag<double, 1> d;
    const auto copies =
        copies_at(d, hn::Set(d, periods.x), hn::Set(d, periods.y), hn::Set(d, strength));
    const auto number = [](auto value) HWY_ATTR { return hn::GetLane(value); };
    GroundCopy copy;
    copy.aside = {number(copies.aside_east.value), number(copies.aside_north.value)};
    copy.way[0] = {1.0 + number(copies.aside_east.east), number(copies.aside_north.east)};
    copy.way[1] = {number(copies.aside_east.north), 1.0 + number(copies.aside_north.north)};
    copy.height = number(copies.height.value);
    copy.growth = {number(copies.height.east), number(copies.height.north)};
    return copy;
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::far_copies
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::far_copies {

HWY_EXPORT(copy_at);

GroundCopy copy_at(const glm::dvec2& periods, double strength) {
    return HWY_DYNAMIC_DISPATCH(copy_at)(periods, strength);
}

}  // namespace fumon::far_copies
#endif
