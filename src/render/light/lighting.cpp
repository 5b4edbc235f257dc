#include "render/light/lighting.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"
#include "render/light/light_vectors.h"
#include "render/light/sky_visibility.h"
#include "render/light/sun_sweep.h"

namespace fumon {

LightTexels lighting_texels(const DisplayBed& bed, const SunDirection& sun, WorkerPool& pool) {
    return lighting_texels(
        bed,
        {sun_visibility(bed.z, bed.dx, bed.dy, sun), sky_visibility(bed.z, bed.dx, bed.dy, pool)},
        0, pool);
}

LightTexels lighting_texels(const DisplayBed& bed, const LightShares& shares, int margin,
                            WorkerPool& pool) {
    const int nx = bed.z.nx();
    const int ny = bed.z.ny();
    const float scale = 65535.0F / (shares.bounds.highest - shares.bounds.lowest);
    const light_vectors::SunTexel sun_texel{scale, -scale * shares.bounds.lowest};
    const int across = nx - 2 * margin;
    LightTexels texels(4 * static_cast<std::size_t>(across) *
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
            const float scale_y =
                north > south ? 1.0F / (bed.dy * static_cast<float>(north - south)) : 0.0F;
            light_vectors::pack_texels({bed.z.row(south).data() + margin, row.data() + margin,
                                        bed.z.row(north).data() + margin, 0.5F / bed.dx, scale_y},
                                       shares.sun.row(y).data() + margin,
                                       shares.sky.row(y).data() + margin, sun_texel, across,
                                       texels.data() + 4 * static_cast<std::size_t>(inner) *
                                                           static_cast<std::size_t>(across));
        }
    });
    return texels;
}

}  // namespace fumon
