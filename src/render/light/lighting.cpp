#include "render/light/lighting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/multiversion.h"
#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/light/sky_visibility.h"
#include "render/light/sun_sweep.h"

namespace fumon {

namespace {

struct Slopes {
    float scale_x;
    float scale_y;
};

/// From a share of the sun to its texel.
struct SunTexel {
    float scale;
    float offset;
};

/// One row of texels. `row` has one place of padding at each end.
FUMON_MULTIVERSION
void pack_row(const float* __restrict south, const float* __restrict row,
              const float* __restrict north, const float* __restrict sun,
              const float* __restrict sky, Slopes slopes, SunTexel sun_texel, int count,
              std::uint16_t* __restrict texels) {
    for (int x = 0; x < count; ++x) {
        const float p = slopes.scale_x * (row[x + 2] - row[x]);
        const float q = slopes.scale_y * (north[x] - south[x]);
        const float length = std::sqrt(1.0F + p * p + q * q);
        std::uint16_t* texel = texels + 4 * static_cast<std::ptrdiff_t>(x);
        texel[0] = static_cast<std::uint16_t>(nearest(32767.0F - 32767.0F * p / length));
        texel[1] = static_cast<std::uint16_t>(nearest(32767.0F - 32767.0F * q / length));
        texel[2] = static_cast<std::uint16_t>(nearest(sun_texel.scale * sun[x] + sun_texel.offset));
        texel[3] = static_cast<std::uint16_t>(nearest(65535.0F * sky[x]));
    }
}

}  // namespace

std::vector<std::uint16_t> lighting_texels(const DisplayBed& bed, const SunDirection& sun,
                                           WorkerPool& pool) {
    return lighting_texels(
        bed,
        {sun_visibility(bed.z, bed.dx, bed.dy, sun), sky_visibility(bed.z, bed.dx, bed.dy, pool)},
        0, pool);
}

std::vector<std::uint16_t> lighting_texels(const DisplayBed& bed, const LightShares& shares,
                                           int margin, WorkerPool& pool) {
    const int nx = bed.z.nx();
    const int ny = bed.z.ny();
    const float scale = 65535.0F / (shares.bounds.highest - shares.bounds.lowest);
    const SunTexel sun_texel{scale, -scale * shares.bounds.lowest};
    const int across = nx - 2 * margin;
    std::vector<std::uint16_t> texels(4 * static_cast<std::size_t>(across) *
                                      static_cast<std::size_t>(ny - 2 * margin));
    pool.for_ranges(ny - 2 * margin, [&](int begin, int end) {
        std::vector<float> row(static_cast<std::size_t>(nx) + 2);
        for (int inner = begin; inner < end; ++inner) {
            const int y = inner + margin;
            const int south = std::max(y - 1, 0);
            const int north = std::min(y + 1, ny - 1);
            std::copy_n(bed.z.row(y).data(), nx, row.begin() + 1);
            row.front() = nx > 1 ? 2.0F * row[1] - row[2] : row[1];
            const auto last = static_cast<std::size_t>(nx);
            row.back() = nx > 1 ? 2.0F * row[last] - row[last - 1] : row[last];
            const Slopes slopes{
                0.5F / bed.dx,
                north > south ? 1.0F / (bed.dy * static_cast<float>(north - south)) : 0.0F};
            pack_row(bed.z.row(south).data() + margin, row.data() + margin,
                     bed.z.row(north).data() + margin, shares.sun.row(y).data() + margin,
                     shares.sky.row(y).data() + margin, slopes, sun_texel, across,
                     texels.data() +
                         4 * static_cast<std::size_t>(inner) * static_cast<std::size_t>(across));
        }
    });
    return texels;
}

}  // namespace fumon
