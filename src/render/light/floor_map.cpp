#include "render/light/floor_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/light/sky_visibility.h"

namespace fumon {

namespace {

constexpr int n = FloorMap::cells;
constexpr float softening = 0.05F;  // tangent: limbs of the sun moved apart, for a soft shadow
constexpr int rings = 5;  // cells under the block that take their neighbours' light, for filtering

struct Cell {
    int x;
    int y;
};

/// Columns and rows [begin, end) outside which nothing stands, however it is turned about the
/// middle.
struct Reach {
    int begin = n;
    int end = 0;
};

Reach reach_of(const Field<std::uint8_t>& covered) {
    constexpr double middle = 0.5 * (n - 1);
    double farthest = -1.0;  // squared, cells
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            if (covered(x, y) == 0) continue;
            const double east = x - middle;
            const double north = y - middle;
            farthest = std::max(farthest, east * east + north * north);
        }
    }
    if (farthest < 0.0) return {};
    constexpr int beside = 3;  // what interpolation and a cell's neighbours add
    const int reach = static_cast<int>(std::sqrt(farthest)) + beside;
    return {std::max(n / 2 - reach, 0), std::min(n / 2 + reach, n)};
}

/// 1 in the cells of a mask of 0 and 1 and in those beside them, but not on the map's border.
Field<std::uint8_t> widened(const Field<std::uint8_t>& mask) {
    Field<std::uint8_t> result(n, n, 0);
    std::array<std::uint8_t, n> columns{};
    for (int y = 1; y + 1 < n; ++y) {
        const std::uint8_t* south = mask.row(y - 1).data();
        const std::uint8_t* here = mask.row(y).data();
        const std::uint8_t* north = mask.row(y + 1).data();
        for (std::size_t x = 0; x < n; ++x)
            columns[x] = static_cast<std::uint8_t>(south[x] | here[x] | north[x]);
        std::uint8_t* out = result.row(y).data();
        for (std::size_t x = 1; x + 1 < n; ++x)
            out[x] = static_cast<std::uint8_t>(columns[x - 1] | columns[x] | columns[x + 1]);
    }
    return result;
}

/// The covered cells beside others that are not.
std::vector<Cell> edge_of(const Field<std::uint8_t>& covered, Reach reach) {
    Field<std::uint8_t> open = covered;
    for (std::uint8_t& cell : open.values()) cell ^= 1U;
    const Field<std::uint8_t> at_open = widened(open);
    std::vector<Cell> edge;
    for (int y = reach.begin; y < reach.end; ++y)
        for (int x = reach.begin; x < reach.end; ++x)
            if ((covered(x, y) & at_open(x, y)) != 0) edge.push_back({x, y});
    return edge;
}

/// A covered cell's light from its neighbours that are not.
float light_around(const Field<float>& light, const Field<std::uint8_t>& covered, Cell cell) {
    float sum = 0.0F;
    int count = 0;
    for (int v = cell.y - 1; v <= cell.y + 1; ++v) {
        for (int u = cell.x - 1; u <= cell.x + 1; ++u) {
            if (covered(u, v) != 0) continue;
            sum += light(u, v);
            ++count;
        }
    }
    return sum / static_cast<float>(count);
}

/// The light just outside the block continues a little under it, so that filtering does not mix in
/// what lies on top.
void continue_under(Field<float>& light, Field<std::uint8_t> covered, Reach reach) {
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<Cell> edge = edge_of(covered, reach);
        for (const Cell cell : edge) light(cell.x, cell.y) = light_around(light, covered, cell);
        for (const Cell cell : edge) covered(cell.x, cell.y) = 0;
    }
}

/// An angle by its cosine and sine.
struct Rotation {
    double cosine;
    double sine;
};

/// A field turned about its middle, in between linear, within `reach` both ways; `outside` beyond
/// that and where the field does not reach.
Field<float> rotated(const Field<float>& field, const Rotation& turn, float outside, Reach reach) {
    Field<float> result(n, n, outside);
    constexpr double middle = 0.5 * (n - 1);
    for (int y = reach.begin; y < reach.end; ++y) {
        for (int x = reach.begin; x < reach.end; ++x) {
            const double u = middle + turn.cosine * (x - middle) + turn.sine * (y - middle);
            const double v = middle - turn.sine * (x - middle) + turn.cosine * (y - middle);
            if (u < 0.0 || v < 0.0 || u >= n - 1 || v >= n - 1) continue;
            const int west = static_cast<int>(u);
            const int south = static_cast<int>(v);
            const auto east_share = static_cast<float>(u - west);
            const auto north_share = static_cast<float>(v - south);
            const auto along = [&](int row) {
                return field(west, row) + east_share * (field(west + 1, row) - field(west, row));
            };
            result(x, y) = along(south) + north_share * (along(south + 1) - along(south));
        }
    }
    return result;
}

/// The cells that a turned block covers and those beside it, whose slope a sweep takes for the
/// wall's.
Field<std::uint8_t> at_block(const Field<float>& cover) {
    Field<std::uint8_t> mask(n, n);
    std::transform(cover.values().begin(), cover.values().end(), mask.values().begin(),
                   [](float share) { return static_cast<std::uint8_t>(share > 0.0F ? 1 : 0); });
    return widened(mask);
}

/// The sky's share seen in 32 directions, the 8 of a lattice that is turned: else the block's
/// corners cast star-shaped wedges of shade.
Field<float> open_sky(const Field<float>& heights, const Field<std::uint8_t>& covered, Reach reach,
                      float width, WorkerPool& pool) {
    constexpr std::array<Rotation, 4> turns = {{{1.0, 0.0},
                                                {0.98078528040323044, 0.19509032201612827},
                                                {0.92387953251128676, 0.38268343236508977},
                                                {0.83146961230254524, 0.55557023301960222}}};
    Field<float> cover(n, n, 0.0F);
    std::transform(covered.values().begin(), covered.values().end(), cover.values().begin(),
                   [](std::uint8_t cell) { return static_cast<float>(cell); });
    Field<float> sum(n, n, 0.0F);
    for (const Rotation& turn : turns) {
        const Field<std::uint8_t> mask = at_block(rotated(cover, turn, 0.0F, reach));
        Field<float> sky = sky_visibility(rotated(heights, turn, 0.0F, reach), width, width, pool);
        continue_under(sky, mask, reach);
        const Field<float> back = rotated(sky, {turn.cosine, -turn.sine}, 1.0F, {0, n});
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum.values()[i] += back.values()[i] / static_cast<float>(turns.size());
    }
    return sum;
}

/// The share of a source that is as wide along the horizon, `half_width` radians to either side, as
/// between its limbs: the mean over upright strips of its disc.
Field<float> share_of_disc(const Field<float>& heights, float width, const SunDirection& source,
                           double half_width) {
    if (half_width == 0.0) return sun_visibility(heights, width, width, source);
    constexpr std::array<double, 5> across = {-0.8, -0.4, 0.0, 0.4, 0.8};
    Field<float> sum(n, n, 0.0F);
    const auto middle = 0.5F * (source.lower_limb + source.upper_limb);
    const auto half = 0.5F * (source.upper_limb - source.lower_limb);
    float weights = 0.0F;
    for (const double place : across) {
        const auto tall = static_cast<float>(std::sqrt(1.0 - place * place));
        const auto sine = static_cast<float>(elementary::sin(place * half_width));
        const auto cosine = static_cast<float>(elementary::cos(place * half_width));
        const SunDirection strip{cosine * source.east + sine * source.north,
                                 cosine * source.north - sine * source.east, middle - tall * half,
                                 middle + tall * half};
        const Field<float> share = sun_visibility(heights, width, width, strip);
        for (std::size_t i = 0; i < sum.size(); ++i) sum.values()[i] += tall * share.values()[i];
        weights += tall;
    }
    for (float& share : sum.values()) share /= weights;
    return sum;
}

/// Each cell averaged with its neighbours (1 2 1 both ways): the sweep's steps along straight walls
/// do not show.
Field<float> smoothed(const Field<float>& light) {
    Field<float> result = light;
    for (int y = 1; y + 1 < n; ++y) {
        const float* south = light.row(y - 1).data();
        const float* here = light.row(y).data();
        const float* north = light.row(y + 1).data();
        float* out = result.row(y).data();
        for (std::size_t x = 1; x + 1 < n; ++x) {
            float sum = south[x - 1] + 2.0F * south[x] + south[x + 1];
            sum += 2.0F * (here[x - 1] + 2.0F * here[x] + here[x + 1]);
            sum += north[x - 1] + 2.0F * north[x] + north[x + 1];
            out[x] = sum / 16.0F;
        }
    }
    return result;
}

/// The cell of a bed of `count` cells that is under each cell of the map along one side, −1 where
/// none is.
std::array<int, n> cells_of_bed(double width, int count) {
    std::array<int, n> cells{};
    constexpr double cell = 2.0 * FloorMap::half_width / n;
    for (int i = 0; i < n; ++i) {
        const double position = ((i + 0.5) * cell - FloorMap::half_width) / width + 0.5;
        cells[static_cast<std::size_t>(i)] =
            position < 0.0 || position >= 1.0 ? -1 : static_cast<int>(position * count);
    }
    return cells;
}

}  // namespace

FloorMap floor_map(const DisplayBed& bed, const Block& block, const SunDirection& sun,
                   WorkerPool& pool, double half_width) {
    Field<float> heights(n, n, 0.0F);
    Field<std::uint8_t> covered(n, n, 0);
    const std::array<int, n> columns = cells_of_bed(block.width_x, bed.z.nx());
    const std::array<int, n> rows = cells_of_bed(block.width_y, bed.z.ny());
    for (int y = 0; y < n; ++y) {
        const int v = rows[static_cast<std::size_t>(y)];
        if (v < 0) continue;
        for (int x = 0; x < n; ++x) {
            const int u = columns[static_cast<std::size_t>(x)];
            if (u < 0 || (!bed.nodata.empty() && bed.nodata(u, v) != 0)) continue;
            heights(x, y) = bed.z(u, v) - static_cast<float>(block.base);
            covered(x, y) = 1;
        }
    }
    constexpr double cell = 2.0 * FloorMap::half_width / n;
    const auto width = static_cast<float>(cell);
    SunDirection soft = sun;
    soft.lower_limb = std::max(sun.lower_limb - softening, 0.5F * sun.lower_limb);
    soft.upper_limb += softening;
    Field<float> sun_share = share_of_disc(heights, width, soft, half_width);
    const Reach reach = reach_of(covered);
    const Field<float> sky_share = open_sky(heights, covered, reach, width, pool);
    continue_under(sun_share, covered, reach);
    sun_share = smoothed(sun_share);
    FloorMap map;
    map.sun_and_sky.resize(2 * heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        map.sun_and_sky[2 * i] = static_cast<std::uint8_t>(nearest(255.0F * sun_share.values()[i]));
        map.sun_and_sky[2 * i + 1] =
            static_cast<std::uint8_t>(nearest(255.0F * sky_share.values()[i]));
    }
    return map;
}

FloorMap open_floor() {
    constexpr std::uint8_t whole = 255;
    return {std::vector<std::uint8_t>(2 * std::size_t{n} * n, whole)};
}

}  // namespace fumon
