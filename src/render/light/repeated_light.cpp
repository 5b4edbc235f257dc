#include "render/light/repeated_light.h"

#include <algorithm>

#include "base/rounding.h"
#include "numerics/resampling.h"
#include "render/light/lighting.h"
#include "render/light/sky_visibility.h"
#include "render/view/display_bed.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

constexpr int read_around = 2;  // cells that the refinement and slopes look at

/// A periodic field on finer cells, with a margin of one of these.
Field<float> refined_around(const Field<float>& field, int refinement) {
    return without_margin(refined(with_margin(field, read_around), refinement),
                          read_around * refinement - 1);
}

/// The sky's share of each cell, as horizons up to half a period away make it.
Field<float> repeated_sky(const Field<float>& z, float dx, float dy, WorkerPool& pool) {
    const int margin = (std::max(z.nx(), z.ny()) + 1) / 2;
    return without_margin(sky_visibility(with_margin(z, margin), dx, dy, pool), margin);
}

}  // namespace

RepeatedLight repeated_light(const Snapshot& snapshot, const Block& block, int refinement,
                             const SunDirection& sun, const Way& way, WorkerPool& pool) {
    const DisplayBed coarse = display_bed(snapshot, block, 1);
    DisplayBed wide;
    wide.z = refined_around(coarse.z, refinement);
    wide.dx = coarse.dx / static_cast<float>(refinement);
    wide.dy = coarse.dy / static_cast<float>(refinement);
    RepeatedLight light;
    light.z = without_margin(wide.z, 1);

    LightShares shares{
        with_margin(
            sun_visibility(light.z, wide.dx, wide.dy, sun, sun_bounds, LatticeBorder::periodic), 1),
        refined_around(repeated_sky(coarse.z, coarse.dx, coarse.dy, pool), refinement), sun_bounds};
    for (float& share : shares.sky.values()) share = std::clamp(share, 0.0F, 1.0F);
    light.texels = lighting_texels(wide, shares, 1, pool);

    constexpr float whole = 65535.0F / (sun_bounds.highest - sun_bounds.lowest);
    const auto dark = static_cast<std::uint16_t>(nearest(-whole * sun_bounds.lowest));
    const auto lit = static_cast<std::uint16_t>(nearest(whole * (1.0F - sun_bounds.lowest)));
    light.clamped = light.texels;
    for (std::size_t i = 2; i < light.clamped.size(); i += 4)
        light.clamped[i] = std::clamp(light.clamped[i], dark, lit);

    constexpr float full_shadow = 0.1763F;  // tan 10°
    constexpr float no_shadow = 0.2679F;    // tan 15°
    const SunDirection upwind{static_cast<float>(-way.x), static_cast<float>(-way.y), full_shadow,
                              no_shadow};
    const Field<float> wind =
        sun_visibility(light.z, wide.dx, wide.dy, upwind, {}, LatticeBorder::periodic);
    light.wind.reserve(wind.size());
    for (const float share : wind.values())
        light.wind.push_back(static_cast<std::uint8_t>(nearest(255.0F * share)));
    return light;
}

}  // namespace fumon
