// The waves of TileWarp, compiled once for each vector target (see vectors/target.h): the same
// bits on each. As shaders/world/tile_warp.glsl.

#if defined(FUMON_TILE_WARP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_TILE_WARP_INL_H
#undef FUMON_TILE_WARP_INL_H
#else
#define FUMON_TILE_WARP_INL_H
#endif

#include <hwy/highway.h>

#include "render/view/tile_warp_waves.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::tile_warp {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A number of each point, and its slopes.
template <class V>
struct Sloped {
    V value;
    V east;
    V north;
};

/// See WarpedGround.
template <class V>
struct WarpFields {
    Sloped<V> aside_east;
    Sloped<V> aside_north;
    Sloped<V> height;
};

/// 0 where ground is as it is … `strength` from `width` farther on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Sloped<V> fade(D d, V east, V north, V range, double width, V strength) {
    const V one = hn::Set(d, 1.0);
    const V from = range - hn::Set(d, unwarped_radius_periods);
    const V t = hn::Min(hn::Max(from * hn::Set(d, 1.0 / width), hn::Zero(d)), one);
    const V growth = strength * hn::Set(d, 6.0 / width) * t * (one - t) /
                     hn::Max(range, hn::Set(d, unwarped_radius_periods));
    return {strength * t * t * (hn::Set(d, 3.0) - (t + t)), growth * east, growth * north};
}

/// Parabolas between −1 and 1, and their slope; `turns` counts wavelengths.
template <class V>
struct Parabolas {
    V value;
    V slope;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Parabolas<V> parabolas(D d, V turns) {
    const V one = hn::Set(d, 1.0);
    const V within = turns - hn::Floor(turns);
    const V across = within + within - one;
    const V inward = one - hn::Abs(across);
    return {hn::Set(d, 4.0) * across * inward, hn::Set(d, 8.0) * (inward + inward - one)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V turns_at(D d, const Wave& wave, V east, V north) {
    return hn::Set(d, wave.east) * east + hn::Set(d, wave.north) * north + hn::Set(d, wave.begin);
}

/// Adds some times a wave.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void add(D d, const Wave& wave, const Parabolas<V>& at, double times, Sloped<V>& sum) {
    sum.value = sum.value + hn::Set(d, times) * at.value;
    sum.east = sum.east + hn::Set(d, times * wave.east) * at.slope;
    sum.north = sum.north + hn::Set(d, times * wave.north) * at.slope;
}

template <class V>
HWY_INLINE Sloped<V> product(const Sloped<V>& a, const Sloped<V>& b) {
    return {a.value * b.value, a.value * b.east + b.value * a.east,
            a.value * b.north + b.value * a.north};
}

template <class V>
HWY_INLINE Sloped<V> sum_of(const Sloped<V>& a, const Sloped<V>& b) {
    return {a.value + b.value, a.east + b.east, a.north + b.north};
}

/// `east` and `north` count periods from the middle of what is as it is; `strength` is
/// 1 where a bed has few landforms.
template <class D, class V = hn::Vec<D>>
HWY_INLINE WarpFields<V> warp_fields_at(D d, V east, V north, V strength) {
    const V zero = hn::Zero(d);
    const Sloped<V> none{zero, zero, zero};
    const V range = hn::Sqrt(east * east + north * north);
    WarpFields<V> few{none, none, none};
    WarpFields<V> many{none, none, none};
    Sloped<V> lower{hn::Set(d, lowered), zero, zero};
    for (const Wave& wave : short_waves) {
        const V turns = turns_at(d, wave, east, north);
        const auto at = parabolas(d, turns);
        add(d, wave, at, wave.aside_east, few.aside_east);
        add(d, wave, at, wave.aside_north, few.aside_north);
        add(d, wave, parabolas(d, turns + hn::Set(d, 0.25)), wave.lower, lower);
    }
    for (const Wave& wave : long_waves) {
        const auto at = parabolas(d, turns_at(d, wave, east, north));
        add(d, wave, at, wave.aside_east, many.aside_east);
        add(d, wave, at, wave.aside_north, many.aside_north);
    }
    const Sloped<V> near = fade(d, east, north, range, short_range, strength);
    const Sloped<V> far = fade(d, east, north, range, long_range, strength);
    const Sloped<V> low = product(fade(d, east, north, range, height_range, strength), lower);
    return {sum_of(product(near, few.aside_east), product(far, many.aside_east)),
            sum_of(product(near, few.aside_north), product(far, many.aside_north)),
            {hn::Set(d, 1.0) - low.value, zero - low.east, zero - low.north}};
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::tile_warp
HWY_AFTER_NAMESPACE();

#endif
