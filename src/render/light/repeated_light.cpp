#include "render/light/repeated_light.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/rounding.h"
#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "numerics/smooth_step.h"
#include "render/edges/sharp_brinks.h"
#include "render/edges/straight_walls.h"
#include "render/light/lighting.h"
#include "render/light/sky_visibility.h"
#include "render/light/tiled_light.h"
#include "render/view/display_bed.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

constexpr int refinement_margin_cells = 9;  // cells that the refinement and slopes look at
constexpr float shade_mean_cells = 2.0F;    // cells along a wall to either side

/// A periodic field on finer cells, with a margin of so many of them.
Field<float> refined_around(const Field<float>& field, int refinement, int margin) {
    return without_margin(refined(with_margin(field, refinement_margin_cells), refinement),
                          refinement_margin_cells * refinement - margin);
}

/// The sky's share of each cell, as horizons up to half a period away make it.
Field<float> repeated_sky(const Field<float>& z, float dx, float dy, WorkerPool& pool) {
    const int margin = (std::max(z.nx(), z.ny()) + 1) / 2;
    return sky_visibility(with_margin(z, margin), dx, dy, pool, margin);
}

/// Between the four nearest cells, at a place some cells away from each.
class ShiftedSampler {
  public:
    ShiftedSampler(float east, float north)
        : west_of_(static_cast<int>(std::floor(east))),
          south_of_(static_cast<int>(std::floor(north))),
          right_(east - std::floor(east)),
          upper_(north - std::floor(north)) {}

    [[nodiscard]] float of(const Field<float>& field, int x, int y) const {
        const auto within = [](int position, int count) {
            while (position < 0) position += count;
            while (position >= count) position -= count;
            return position;
        };
        const int x0 = within(x + west_of_, field.nx());
        const int x1 = within(x + west_of_ + 1, field.nx());
        const int y0 = within(y + south_of_, field.ny());
        const int y1 = within(y + south_of_ + 1, field.ny());
        const float low = field(x0, y0) + right_ * (field(x1, y0) - field(x0, y0));
        const float high = field(x0, y1) + right_ * (field(x1, y1) - field(x0, y1));
        return low + upper_ * (high - low);
    }

  private:
    int west_of_;
    int south_of_;
    float right_;
    float upper_;
};

/// The sun's share of each cell of the maps.
Field<float> sun_over_tiles(const Field<float>& z, const DisplayBed& scale,
                            const GroundTiles& tiles, const SunDirection& sun,
                            const ShareBounds& bounds) {
    const auto repeated = [&](const Field<float>& heights) {
        return sun_visibility(heights, scale.dx, scale.dy, sun, bounds, LatticeBorder::periodic);
    };
    const auto open = [&](const Field<float>& heights, int margin) {
        return without_margin(sun_visibility(heights, scale.dx, scale.dy, sun, bounds), margin);
    };
    return shares_over_tiles(z, tiles, repeated, open);
}

Field<float> sky_over_tiles(const DisplayBed& bed, const GroundTiles& tiles, WorkerPool& pool) {
    const auto repeated = [&](const Field<float>& heights) {
        return repeated_sky(heights, bed.dx, bed.dy, pool);
    };
    const auto open = [&](const Field<float>& heights, int margin) {
        return sky_visibility(heights, bed.dx, bed.dy, pool, margin);
    };
    return shares_over_tiles(bed.z, tiles, repeated, open);
}

/// Shares of the sun whose shadows begin a cell later where the ground turns away from it: its
/// slope shows the edge between cells, and a share does not.
Field<float> with_later_shadows(const Field<float>& share, const Field<float>& z, float dx,
                                float dy, const SunDirection& sun, WorkerPool& pool) {
    const float columns = sun.east / dx;
    const float rows = sun.north / dy;
    const float length = 1.0F / std::max(std::abs(columns), std::abs(rows));
    const ShiftedSampler sunward(length * columns, length * rows);
    const ShiftedSampler away(-length * columns, -length * rows);
    const float grazing = (sun.lower_limb + sun.upper_limb) * length;  // rise over both
    Field<float> later(share.nx(), share.ny());
    pool.for_ranges(share.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < share.nx(); ++x) {
                const float own = share(x, y);
                later(x, y) = own;
                const float gained = std::min(sunward.of(share, x, y), 1.0F) - own;
                if (gained <= 0.0F) continue;
                const float rise = sunward.of(z, x, y) - away.of(z, x, y);
                later(x, y) += gained * std::clamp(rise / grazing - 1.5F, 0.0F, 1.0F);
            }
        }
    });
    return later;
}

/// The edges of walls that turn away from the sun. Their own shade begins at the rim, between two
/// cells, of which the one is far below the other: what these see of the sun is nothing to go by.
Field<Edge> shaded_walls(const Field<Edge>& walls, const Field<float>& z, float dx, float dy,
                         const SunDirection& sun) {
    const Field<float> around = with_margin(z, 1);
    const float grazing = 0.5F * (sun.lower_limb + sun.upper_limb);
    Field<Edge> shaded = walls;
    for (int y = 0; y < z.ny(); ++y) {
        for (int x = 0; x < z.nx(); ++x) {
            if (walls(x, y).share == 0.0F) continue;
            const float east = (around(x + 2, y + 1) - around(x, y + 1)) / (2.0F * dx);
            const float north = (around(x + 1, y + 2) - around(x + 1, y)) / (2.0F * dy);
            const float rise = east * sun.east + north * sun.north;
            shaded(x, y).share *= smooth_step(0.5F * grazing, grazing, rise);
        }
    }
    return shaded;
}

/// How far a face of that slope is in the lee of one of the winds, 0 … 1. A bed in metres keeps the
/// angle of repose, which no wind steepens a face to that it blows against: there all faces are.
float in_lee(const Snapshot& snapshot, float east, float north) {
    if (snapshot.scale.in_metres) return 1.0F;
    const auto downwind = [&](double x, double y) {
        return -(static_cast<float>(x) * east + static_cast<float>(y) * north);
    };
    float most = snapshot.winds.empty() ? downwind(1.0, 0.0) : 0.0F;
    for (const SnapshotWind& wind : snapshot.winds) most = std::max(most, downwind(wind.x, wind.y));
    constexpr float beside = 0.1F;  // cosines of angles to a wind
    constexpr float behind = 0.5F;
    return smooth_step(beside, behind,
                       most / std::max(std::sqrt(east * east + north * north), 1e-6F));
}

/// How far the sand of each cell lies as it slid, 0 … 1: on steep slopes in the lee, without
/// exaggeration, and to a cell from them.
Field<float> avalanche_sand(const DisplayBed& bed, const Snapshot& snapshot, double exaggeration) {
    constexpr float none = 0.40F;  // slopes
    constexpr float all = 0.56F;
    const auto rise = static_cast<float>(0.5 / exaggeration);
    const Field<float> z = with_margin(bed.z, 1);
    Field<float> own(bed.z.nx(), bed.z.ny());
    for (int y = 0; y < own.ny(); ++y) {
        for (int x = 0; x < own.nx(); ++x) {
            const float east = rise * (z(x + 2, y + 1) - z(x, y + 1)) / bed.dx;
            const float north = rise * (z(x + 1, y + 2) - z(x + 1, y)) / bed.dy;
            const float steep = east * east + north * north;
            if (steep <= none * none) continue;
            own(x, y) = smooth_step(none, all, std::sqrt(steep)) * in_lee(snapshot, east, north);
        }
    }
    const Field<float> wide = with_margin(own, 1);
    Field<float> slid(own.nx(), own.ny());
    for (int y = 0; y < slid.ny(); ++y) {
        for (int x = 0; x < slid.nx(); ++x) {
            for (int v = y; v < y + 3; ++v)
                for (int u = x; u < x + 3; ++u) slid(x, y) = std::max(slid(x, y), wide(u, v));
        }
    }
    return slid;
}

std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(nearest(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

}  // namespace

RepeatedLight repeated_light(const Snapshot& snapshot, const Block& block, int refinement,
                             const DrawnOrigin& origin, const SunDirection& sun,
                             const HorizontalDirection& way, WorkerPool& pool) {
    DisplayBed coarse = display_bed(snapshot, block, 1);
    coarse.z = rolled(coarse.z, origin.east, origin.north);
    DisplayBed wide;
    wide.z = without_margin(refined_with_brinks(with_margin(coarse.z, refinement_margin_cells),
                                                coarse.dx, coarse.dy, refinement, pool),
                            refinement_margin_cells * refinement - 1);
    wide.dx = coarse.dx / static_cast<float>(refinement);
    wide.dy = coarse.dy / static_cast<float>(refinement);
    RepeatedLight light;
    light.z = without_margin(wide.z, 1);
    std::optional<StraightWalls> walls;
    if (snapshot.scale.in_metres) {  // other beds are of sand alone, which some rules leave steep
        const auto exaggeration = static_cast<float>(block.exaggeration);
        walls = with_straight_walls(coarse.z, light.z, exaggeration * coarse.dx,
                                    exaggeration * coarse.dy, pool);
    }
    light.walls = walls.has_value();
    if (walls) {
        coarse.z = std::move(walls->coarse);
        light.z = std::move(walls->fine);
        wide.z = with_margin(light.z, 1);
    }
    Field<float> sun_share =
        with_later_shadows(sun_over_tiles(light.z, wide, block.tiles, sun, sun_bounds), light.z,
                           wide.dx, wide.dy, sun, pool);
    if (walls) {
        const Field<Edge> shaded = shaded_walls(walls->edges, coarse.z, coarse.dx, coarse.dy, sun);
        sun_share = averaged_along(shaded, shade_mean_cells, sun_share, pool);
    }

    LightShares shares{with_margin(sun_share, 1),
                       refined_around(sky_over_tiles(coarse, block.tiles, pool), refinement, 1),
                       sun_bounds};
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
    const Field<float> wind = sun_over_tiles(light.z, wide, block.tiles, upwind, {});
    const Field<float> slid =
        refined_around(avalanche_sand(coarse, snapshot, block.exaggeration), refinement, 0);
    light.surface.reserve(2 * wind.size());
    for (std::size_t i = 0; i < wind.size(); ++i) {
        light.surface.push_back(byte_of(wind.values()[i]));
        light.surface.push_back(byte_of(slid.values()[i]));
    }
    light.slid =
        avalanche_cells(light.texels, light.surface, light.z.nx(), light.z.ny(),
                        min_avalanche_slope * static_cast<float>(block.exaggeration), pool);
    return light;
}

}  // namespace fumon
