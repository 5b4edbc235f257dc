#include "render/edges/straight_walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/worker_pool.h"
#include "numerics/smooth_step.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

constexpr float no_wall = 1.5F;  // slopes between neighbouring cells
constexpr float full_wall = 2.25F;
constexpr int apart = 3;   // cells from those that are compared
constexpr int beside = 2;  // cells to either side that are of the wall, and fewer of one more
constexpr int direction_around = 4;   // cells to either side, over which its direction is found
constexpr float averaged = 6.0F;      // cells along it to either side
constexpr float least_aside = 0.15F;  // of a wall that runs nowhere
// By how much more heights vary across than along it, of both.
constexpr float no_direction = 0.6F;
constexpr float one_direction = 0.95F;

bool may_have_walls(const Field<float>& z, float dx, float dy) {
    int steep = 0;  // found without branches, for which the loop would be slower
    for (int y = 0; y < z.ny(); ++y) {
        const auto own = z.row(y);
        const auto north = z.row(y + 1 < z.ny() ? y + 1 : 0);
        const std::size_t last = own.size() - 1;
        for (std::size_t x = 0; x < own.size(); ++x)
            steep |= static_cast<int>(std::abs(north[x] - own[x]) > no_wall * dy);
        for (std::size_t x = 0; x < last; ++x)
            steep |= static_cast<int>(std::abs(own[x + 1] - own[x]) > no_wall * dx);
        steep |= static_cast<int>(std::abs(own[0] - own[last]) > no_wall * dx);
    }
    return steep != 0;
}

/// By what slope a rise from one cell to the next is steeper than those some cells before and after
/// it on the way: slopes that go on have no stairs.
float steeper(const float* z, std::ptrdiff_t next, float cell) {
    const float rise = z[next] - z[0];
    const float sign = rise < 0.0F ? -1.0F : 1.0F;
    const float before = sign * (z[(1 - apart) * next] - z[-apart * next]);
    const float after = sign * (z[(1 + apart) * next] - z[apart * next]);
    return (sign * rise - std::max(std::max(before, after), 0.0F)) / cell;
}

/// How far cells of a periodic bed stand at a wall or beside it, 0 … 1; empty where none does.
Field<float> walls(const Field<float>& z, float dx, float dy) {
    const int nx = z.nx();
    const int ny = z.ny();
    const auto within = [](int position, int count) { return (position % count + count) % count; };
    constexpr int margin = apart + 1;
    const Field<float> wide = with_margin(z, margin);
    Field<float> reached(nx, ny);
    bool any = false;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const float* own = &wide(x + margin, y + margin);
            const float rise = std::max(steeper(own, 1, dx), steeper(own, wide.nx(), dy));
            if (rise <= no_wall) continue;
            any = true;
            const float share = smooth_step(no_wall, full_wall, rise);
            for (int j = -beside - 1; j <= beside + 2; ++j) {
                for (int i = -beside - 1; i <= beside + 2; ++i) {
                    float& there = reached(within(x + i, nx), within(y + j, ny));
                    there = std::max(there, share);
                }
            }
        }
    }
    if (!any) return {};
    const Field<float> around = with_margin(reached, 1);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            float sum = 0.0F;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) sum += around(x + i, y + j);
            reached(x, y) = sum / 9.0F;
        }
    }
    return reached;
}

/// Means of three cells by three, the middle ones twice as much; a margin of one cell less.
Field<float> softened(const Field<float>& z) {
    Field<float> rows(z.nx(), z.ny() - 2);
    for (int y = 0; y < rows.ny(); ++y)
        for (int x = 0; x < rows.nx(); ++x)
            rows(x, y) = 0.25F * (z(x, y) + 2.0F * z(x, y + 1) + z(x, y + 2));
    Field<float> soft(z.nx() - 2, rows.ny());
    for (int y = 0; y < soft.ny(); ++y)
        for (int x = 0; x < soft.nx(); ++x)
            soft(x, y) = 0.25F * (rows(x, y) + 2.0F * rows(x + 1, y) + rows(x + 2, y));
    return soft;
}

/// A unit vector along which heights around a cell vary the least, and as its share how far to look
/// along it, of `averaged`. Of heights with a margin of `direction_around` + 1.
Edge along_wall(const Field<float>& soft, int x, int y) {
    float east_east = 0.0F;
    float east_north = 0.0F;
    float north_north = 0.0F;
    for (int j = 0; j <= 2 * direction_around; ++j) {
        for (int i = 0; i <= 2 * direction_around; ++i) {
            const int u = x + 1 + i;
            const int v = y + 1 + j;
            const float east = soft(u + 1, v) - soft(u - 1, v);
            const float north = soft(u, v + 1) - soft(u, v - 1);
            const auto weight =
                static_cast<float>((direction_around + 1 - std::abs(i - direction_around)) *
                                   (direction_around + 1 - std::abs(j - direction_around)));
            east_east += weight * east * east;
            east_north += weight * east * north;
            north_north += weight * north * north;
        }
    }
    const float half = 0.5F * (east_east - north_north);
    const float split = std::sqrt(half * half + east_north * east_north);
    const float both = east_east + north_north;
    if (split <= 0.0F) return {least_aside, 0.0F, 0.0F, 0.0F};
    // Across the wall lies (half + split, east_north), or as well (east_north, split - half): the
    // longer one has the fewer rounding errors.
    float east = -east_north;
    float north = half + split;
    if (half < 0.0F) {
        east = half - split;
        north = east_north;
    }
    const float length = std::sqrt(east * east + north * north);
    const float far = least_aside + (1.0F - least_aside) * smooth_step(no_direction, one_direction,
                                                                       2.0F * split / both);
    return {far, 0.0F, east / length, north / length};
}

/// How far to look along a wall from a cell, of `averaged`: not past a corner, about which walls
/// run nowhere. `far`: what is known of each cell alone, with a margin of `averaged`.
float far_along(const Field<float>& far, int x, int y) {
    constexpr int reach = static_cast<int>(averaged);
    float least = 1.0F;
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const float there = far(x + reach + i, y + reach + j);
            if (there >= least) continue;
            const float away = std::sqrt(static_cast<float>(i * i + j * j)) / averaged;
            least = std::min(least, there + away);
        }
    }
    return least;
}

/// The walls of a bed, whose cells stand at them as far as `share` says.
Field<Edge> edges_of(const Field<float>& coarse, const Field<float>& share, WorkerPool& pool) {
    const Field<float> soft = softened(softened(with_margin(coarse, direction_around + 3)));
    Field<Edge> edges(coarse.nx(), coarse.ny());
    Field<float> far(coarse.nx(), coarse.ny(), 1.0F);
    const auto for_cells = [&](const auto& call) {
        pool.for_ranges(coarse.ny(), [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < coarse.nx(); ++x)
                    if (share(x, y) > 0.0F) call(x, y);
            }
        });
    };
    for_cells([&](int x, int y) {
        edges(x, y) = along_wall(soft, x, y);
        far(x, y) = edges(x, y).share;
    });
    const Field<float> around = with_margin(far, static_cast<int>(averaged));
    for_cells([&](int x, int y) {
        const float length = far_along(around, x, y);
        const Edge& edge = edges(x, y);
        edges(x, y) = {share(x, y), 0.0F, length * edge.east, length * edge.north};
    });
    return edges;
}

/// Keeps heights about walls within those of the four cells around.
void keep_within(const Field<float>& coarse, const Field<float>& share, Field<float>& fine,
                 WorkerPool& pool) {
    const int refinement = fine.nx() / coarse.nx();
    if (refinement == 1) return;
    const Field<float> around = with_margin(coarse, 1);
    pool.for_ranges(fine.ny(), [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const int y = v / refinement;
            const int south = y + (2 * (v % refinement) + 1 < refinement ? 0 : 1);
            for (int u = 0; u < fine.nx(); ++u) {
                const int x = u / refinement;
                if (share(x, y) == 0.0F) continue;
                const int west = x + (2 * (u % refinement) + 1 < refinement ? 0 : 1);
                const auto [lowest, highest] =
                    std::minmax({around(west, south), around(west + 1, south),
                                 around(west, south + 1), around(west + 1, south + 1)});
                float& z = fine(u, v);
                z += share(x, y) * (std::clamp(z, lowest, highest) - z);
            }
        }
    });
}

/// Of fine cells in each coarse one about a wall.
void convert_to_means(const Field<float>& fine, const Field<float>& share, Field<float>& coarse) {
    const int refinement = fine.nx() / coarse.nx();
    for (int y = 0; y < coarse.ny(); ++y) {
        for (int x = 0; x < coarse.nx(); ++x) {
            if (share(x, y) == 0.0F) continue;
            float sum = 0.0F;
            for (int j = 0; j < refinement; ++j)
                for (int i = 0; i < refinement; ++i)
                    sum += fine(x * refinement + i, y * refinement + j);
            const float mean = sum / static_cast<float>(refinement * refinement);
            coarse(x, y) += share(x, y) * (mean - coarse(x, y));
        }
    }
}

}  // namespace

Field<float> averaged_along(const Field<Edge>& walls, float cells_aside, const Field<float>& fine,
                            WorkerPool& pool) {
    const int refinement = fine.nx() / walls.nx();
    const int margin = static_cast<int>(cells_aside) + 2;
    Field<float> around = with_margin(fine, margin * refinement);
    smooth_along_edges(with_margin(walls, margin), refinement, cells_aside, around, pool);
    return without_margin(around, margin * refinement);
}

std::optional<StraightWalls> with_straight_walls(const Field<float>& coarse,
                                                 const Field<float>& fine, float dx, float dy,
                                                 WorkerPool& pool) {
    if (!may_have_walls(coarse, dx, dy)) return std::nullopt;
    const Field<float> share = walls(coarse, dx, dy);
    if (share.empty()) return std::nullopt;
    StraightWalls straight{edges_of(coarse, share, pool), coarse, fine};
    keep_within(coarse, share, straight.fine, pool);
    straight.fine = averaged_along(straight.edges, averaged, straight.fine, pool);
    convert_to_means(straight.fine, share, straight.coarse);
    return straight;
}

}  // namespace fumon
