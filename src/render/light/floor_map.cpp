#include "render/light/floor_map.h"

#include <algorithm>
#include <cmath>

#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/light/sky_visibility.h"

namespace fumon {

namespace {

constexpr int n = FloorMap::cells;
constexpr float softening = 0.05F;  // tangent: limbs of the sun moved apart, for a soft shadow
constexpr int rings = 2;  // cells under the block that take their neighbours' light, for filtering

/// The light just outside the block continues a little under it, so that filtering does not mix in
/// what lies on top.
void continue_under(Field<float>& light, Field<std::uint8_t> covered) {
    for (int ring = 0; ring < rings; ++ring) {
        const Field<std::uint8_t> before = covered;
        for (int y = 1; y + 1 < n; ++y) {
            for (int x = 1; x + 1 < n; ++x) {
                if (before(x, y) == 0) continue;
                float lightest = -1.0F;
                for (int v = y - 1; v <= y + 1; ++v) {
                    for (int u = x - 1; u <= x + 1; ++u)
                        if (before(u, v) == 0) lightest = std::max(lightest, light(u, v));
                }
                if (lightest < 0.0F) continue;
                light(x, y) = lightest;
                covered(x, y) = 0;
            }
        }
    }
}

/// Each cell averaged with its neighbours (1 2 1 both ways): the sweep's steps along straight walls
/// do not show.
Field<float> smoothed(const Field<float>& light) {
    Field<float> result = light;
    for (int y = 1; y + 1 < n; ++y) {
        for (int x = 1; x + 1 < n; ++x) {
            float sum = 0.0F;
            for (int v = -1; v <= 1; ++v) {
                sum += static_cast<float>(2 - v * v) *
                       (light(x - 1, y + v) + 2.0F * light(x, y + v) + light(x + 1, y + v));
            }
            result(x, y) = sum / 16.0F;
        }
    }
    return result;
}

}  // namespace

FloorMap floor_map(const DisplayBed& bed, const Block& block, const SunDirection& sun,
                   WorkerPool& pool) {
    Field<float> heights(n, n, 0.0F);
    Field<std::uint8_t> covered(n, n, 0);
    const double cell = 2.0 * FloorMap::half_width / n;
    for (int y = 0; y < n; ++y) {
        const double north = ((y + 0.5) * cell - FloorMap::half_width) / block.width_y + 0.5;
        if (north < 0.0 || north >= 1.0) continue;
        const int v = static_cast<int>(north * bed.z.ny());
        for (int x = 0; x < n; ++x) {
            const double east = ((x + 0.5) * cell - FloorMap::half_width) / block.width_x + 0.5;
            if (east < 0.0 || east >= 1.0) continue;
            const int u = static_cast<int>(east * bed.z.nx());
            if (!bed.nodata.empty() && bed.nodata(u, v) != 0) continue;
            heights(x, y) = bed.z(u, v) - static_cast<float>(block.base);
            covered(x, y) = 1;
        }
    }
    const auto width = static_cast<float>(cell);
    SunDirection soft = sun;
    soft.lower_limb = std::max(sun.lower_limb - softening, 0.5F * sun.lower_limb);
    soft.upper_limb += softening;
    Field<float> sun_share = sun_visibility(heights, width, width, soft);
    Field<float> sky_share = sky_visibility(heights, width, width, pool);
    continue_under(sun_share, covered);
    continue_under(sky_share, covered);
    sun_share = smoothed(sun_share);
    FloorMap map;
    map.sun_and_sky.reserve(2 * heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        map.sun_and_sky.push_back(
            static_cast<std::uint8_t>(nearest(255.0F * sun_share.values()[i])));
        map.sun_and_sky.push_back(
            static_cast<std::uint8_t>(nearest(255.0F * sky_share.values()[i])));
    }
    return map;
}

}  // namespace fumon
