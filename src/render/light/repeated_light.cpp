#include "render/light/repeated_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// Shadows that begin a cell later: where a shadow begins the ground turns away from the sun, which
/// its slope shows between cells, and a share does not.
Field<float> with_later_shadows(const Field<float>& share, float dx, float dy,
                                const SunDirection& sun) {
    const int nx = share.nx();
    const int ny = share.ny();
    const float columns = sun.east / dx;
    const float rows = sun.north / dy;
    const float longer = std::max(std::abs(columns), std::abs(rows));
    const float east = columns / longer;
    const float north = rows / longer;
    const auto west_of = static_cast<int>(std::floor(east));
    const auto south_of = static_cast<int>(std::floor(north));
    const float right = east - static_cast<float>(west_of);
    const float upper = north - static_cast<float>(south_of);
    const auto within = [](int place, int count) { return (place + count) % count; };
    Field<float> later(nx, ny);
    for (int y = 0; y < ny; ++y) {
        const auto lower_row = share.row(within(y + south_of, ny));
        const auto upper_row = share.row(within(y + south_of + 1, ny));
        const auto own = share.row(y);
        const auto result = later.row(y);
        for (int x = 0; x < nx; ++x) {
            const auto a = static_cast<std::size_t>(within(x + west_of, nx));
            const auto b = static_cast<std::size_t>(within(x + west_of + 1, nx));
            const float low = lower_row[a] + right * (lower_row[b] - lower_row[a]);
            const float high = upper_row[a] + right * (upper_row[b] - upper_row[a]);
            const auto i = static_cast<std::size_t>(x);
            result[i] = std::max(own[i], low + upper * (high - low));
        }
    }
    return later;
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
        with_margin(with_later_shadows(sun_visibility(light.z, wide.dx, wide.dy, sun, sun_bounds,
                                                      LatticeBorder::periodic),
                                       wide.dx, wide.dy, sun),
                    1),
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
