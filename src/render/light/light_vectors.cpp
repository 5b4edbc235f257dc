#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/light/light_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <cstddef>
#include <numbers>

#include "render/light/light_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::light_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using One = hn::CappedTag<float, 1>;

/// Calls loop(d, x) for whole vectors of a row, and cell after cell by a tag of one lane past them.
template <class Loop>
HWY_INLINE void for_each_cell(int count, const Loop& loop) {
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    const auto cells = static_cast<std::size_t>(count);
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes) loop(Floats(), x);
#pragma GCC unroll 1
    for (; x < cells; ++x) loop(One(), x);
}

template <class D>
HWY_INLINE hn::Vec<D> clamped_to_share(D d, hn::Vec<D> value) {
    return hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1.0F));
}

void sweep_shadow(const ShadowStep& step, const float* heights, const Shadow& before,
                  const Shadow& after, float* visibility) {
    for_each_cell(step.count, [&](auto d, std::size_t x) HWY_ATTR {
        const auto near = hn::Set(d, 1.0F - step.fraction);
        const auto far = hn::Set(d, step.fraction);
        const auto widening = hn::Set(d, step.upper_drop - step.lower_drop);
        const auto between = [&](const float* row) HWY_ATTR {
            return near * hn::LoadU(d, row + x) + far * hn::LoadU(d, row + x + 1);
        };
        const auto z = hn::LoadU(d, heights + x);
        const auto low = between(before.lower) - hn::Set(d, step.lower_drop);
        const auto high = between(before.upper) - hn::Set(d, step.upper_drop);
        const auto low_width = between(before.lower_width) + widening;
        const auto high_width = between(before.upper_width) + widening;
        const auto by_lower = hn::Set(d, 1.0F) + (z - low) / low_width;
        const auto by_upper = (z - high) / high_width;
        const auto share = hn::Max(hn::Min(by_upper, by_lower), hn::Set(d, step.lowest));
        hn::StoreU(hn::Min(share, hn::Set(d, step.highest)), d, visibility + x);
        const auto over_low = hn::Ge(z, low);
        const auto over_high = hn::Ge(z, high);
        hn::StoreU(hn::IfThenElse(over_low, z, low), d, after.lower + x);
        hn::StoreU(hn::IfThenZeroElse(over_low, low_width), d, after.lower_width + x);
        hn::StoreU(hn::IfThenElse(over_high, z, high), d, after.upper + x);
        hn::StoreU(hn::IfThenZeroElse(over_high, high_width), d, after.upper_width + x);
    });
}

/// elementary::rough_atan.
template <class D>
HWY_INLINE hn::Vec<D> rough_atan(D d, hn::Vec<D> t) {
    const auto square = t * t;
    auto series = hn::Set(d, -0.0851330F) + square * hn::Set(d, 0.0208351F);
    series = hn::Set(d, 0.1801410F) + square * series;
    series = hn::Set(d, -0.3302995F) + square * series;
    return t * (hn::Set(d, 0.9998660F) + square * series);
}

/// π/2 − θ − sin θ cos θ and cos² θ for θ = atan t, t ≥ 0.
template <class V>
struct SkyAbove {
    V tilted;
    V level;
};

template <class D>
HWY_INLINE SkyAbove<hn::Vec<D>> sky_above(D d, hn::Vec<D> t) {
    const auto one = hn::Set(d, 1.0F);
    const auto quarter = hn::Set(d, std::numbers::pi_v<float> / 2.0F);
    const auto arc = rough_atan(d, hn::Min(t, one) / hn::Max(t, one));
    const auto level = one / (one + t * t);
    return {hn::IfThenElse(hn::Gt(t, one), arc, quarter - arc) - t * level, level};
}

void add_sky(const float* z, int count, const float* back, const float* ahead, float spacing,
             float weight, float* sum) {
    const float per_length = 1.0F / spacing;
    for_each_cell(count, [&](auto d, std::size_t x) HWY_ATTR {
        const auto scale = hn::Set(d, per_length);
        const auto zero = hn::Zero(d);
        const auto rise = hn::LoadU(d, z + x + 1) - hn::LoadU(d, z + x - 1);
        const auto slope = hn::Set(d, 0.5F * per_length) * rise;
        const auto behind = sky_above(d, hn::Max(hn::LoadU(d, back + x) * scale, zero));
        const auto before = sky_above(d, hn::Max(hn::LoadU(d, ahead + x) * scale, zero));
        const auto seen = behind.level + before.level + slope * (behind.tilted - before.tilted);
        hn::StoreU(hn::LoadU(d, sum + x) + hn::Set(d, weight) * seen, d, sum + x);
    });
}

template <class V>
struct Slope {
    V east;
    V north;
    V length;  ///< of the normal whose upward part is 1
};

template <class D>
HWY_INLINE Slope<hn::Vec<D>> slope_at(D d, const ThreeRows& heights, std::size_t x) {
    const auto east = hn::Set(d, heights.scale_x) *
                      (hn::LoadU(d, heights.row + x + 2) - hn::LoadU(d, heights.row + x));
    const auto north = hn::Set(d, heights.scale_y) *
                       (hn::LoadU(d, heights.north + x) - hn::LoadU(d, heights.south + x));
    return {east, north, hn::Sqrt(hn::Set(d, 1.0F) + east * east + north * north)};
}

void multiply_by_normal(const ThreeRows& heights, int count, float* sum) {
    for_each_cell(count, [&](auto d, std::size_t x) HWY_ATTR {
        const auto slope = slope_at(d, heights, x);
        hn::StoreU(clamped_to_share(d, hn::LoadU(d, sum + x) / slope.length), d, sum + x);
    });
}

/// The nearest whole number of each of the values ≥ 0, halves upward.
template <class D>
HWY_INLINE auto nearest_of(D d, hn::Vec<D> values) {
    const hn::Rebind<std::int32_t, D> integers;
    const hn::Rebind<std::uint16_t, D> shorts;
    return hn::DemoteTo(shorts, hn::ConvertTo(integers, values + hn::Set(d, 0.5F)));
}

void pack_texels(const ThreeRows& heights, const float* sun, const float* sky,
                 const SunTexel& sun_texel, int count, std::uint16_t* texels) {
    for_each_cell(count, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::Rebind<std::uint16_t, decltype(d)> shorts;
        const auto slope = slope_at(d, heights, x);
        const auto half = hn::Set(d, 32767.0F);
        const auto whole = hn::Set(d, 65535.0F);
        const auto east = nearest_of(d, half - half * slope.east / slope.length);
        const auto north = nearest_of(d, half - half * slope.north / slope.length);
        const auto sun_share = nearest_of(
            d, hn::Set(d, sun_texel.scale) * hn::LoadU(d, sun + x) + hn::Set(d, sun_texel.offset));
        const auto sky_share = nearest_of(d, whole * hn::LoadU(d, sky + x));
        std::uint16_t* texel = texels + 4 * x;
        if constexpr (hn::MaxLanes(decltype(d)()) == 1) {
            texel[0] = hn::GetLane(east);
            texel[1] = hn::GetLane(north);
            texel[2] = hn::GetLane(sun_share);
            texel[3] = hn::GetLane(sky_share);
        } else {
            hn::StoreInterleaved4(east, north, sun_share, sky_share, shorts, texel);
        }
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::light_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::light_vectors {

HWY_EXPORT(sweep_shadow);
HWY_EXPORT(add_sky);
HWY_EXPORT(multiply_by_normal);
HWY_EXPORT(pack_texels);

void sweep_shadow(const ShadowStep& step, const float* heights, const Shadow& before,
                  const Shadow& after, float* visibility) {
    HWY_DYNAMIC_DISPATCH(sweep_shadow)(step, heights, before, after, visibility);
}

void add_sky(const float* z, int count, const float* back, const float* ahead, float spacing,
             float weight, float* sum) {
    HWY_DYNAMIC_DISPATCH(add_sky)(z, count, back, ahead, spacing, weight, sum);
}

void multiply_by_normal(const ThreeRows& heights, int count, float* sum) {
    HWY_DYNAMIC_DISPATCH(multiply_by_normal)(heights, count, sum);
}

void pack_texels(const ThreeRows& heights, const float* sun, const float* sky,
                 const SunTexel& sun_texel, int count, std::uint16_t* texels) {
    HWY_DYNAMIC_DISPATCH(pack_texels)(heights, sun, sky, sun_texel, count, texels);
}

}  // namespace fumon::light_vectors
#endif
