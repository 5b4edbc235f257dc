#include "render/edges/sharp_brinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "render/edges/edges.h"

namespace fumon {

namespace {

constexpr float no_edge = 0.2F;  // differences of slope
constexpr float full_edge = 0.45F;
constexpr float most_cut =
    0.25F;  // of an edge's height, over a cell, that a smooth surface cuts off

/// Rises over a cell, east and north.
struct Rise {
    float east = 0.0F;
    float north = 0.0F;
};

/// The rise at the middle of five heights in a row, from the side on which it changes less.
float smoother_rise(const std::array<float, 5>& heights) {
    const float far_before = heights[1] - heights[0];
    const float before = heights[2] - heights[1];
    const float after = heights[3] - heights[2];
    const float far_after = heights[4] - heights[3];
    const float bend_before = before - far_before;
    const float bend_after = far_after - after;
    return std::abs(bend_before) <= std::abs(bend_after) ? before : after;
}

Field<Rise> smoother_rises(const Field<float>& heights, WorkerPool& pool) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    Field<Rise> rises(nx, ny);
    pool.for_ranges(ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < nx; ++x) {
                std::array<float, 5> row{};
                std::array<float, 5> column{};
                for (int i = 0; i < 5; ++i) {
                    row[static_cast<std::size_t>(i)] = heights(std::clamp(x + i - 2, 0, nx - 1), y);
                    column[static_cast<std::size_t>(i)] =
                        heights(x, std::clamp(y + i - 2, 0, ny - 1));
                }
                rises(x, y) = {smoother_rise(row), smoother_rise(column)};
            }
        }
    });
    return rises;
}

/// Sums of products of differences of slope.
struct Products {
    float east_east = 0.0F;
    float east_north = 0.0F;
    float north_north = 0.0F;
};

constexpr int looked_around = 3;  // cells to either side, over which an edge's direction is found
constexpr float least_length = 0.2F;  // of an edge that runs nowhere
// How much more slopes differ across than along it, of both.
constexpr float nowhere = 0.65F;
constexpr float straight = 0.9F;

/// The direction in which slopes differ the least.
void turn_along(const Products& sum, Edge& edge) {
    const float half = 0.5F * (sum.east_east - sum.north_north);
    const float larger = half + std::sqrt(half * half + sum.east_north * sum.east_north);
    // Across the edge lies (larger, east_north) where slopes differ eastward the most.
    const float east = larger > 0.0F ? -sum.east_north : -1.0F;
    const float length = std::sqrt(larger * larger + east * east);
    const float differ = sum.east_east + sum.north_north;
    const float along = differ > 0.0F ? 2.0F * (larger - half) / differ : 0.0F;
    const float t = std::clamp((along - nowhere) / (straight - nowhere), 0.0F, 1.0F);
    const float shown = least_length + (1.0F - least_length) * t * t * (3.0F - 2.0F * t);
    edge.east = shown * east / length;
    edge.north = shown * larger / length;
}

/// A call for each cell at most so far from one, along both axes, or for every second one of these.
template <class Field, class Call>
void cells_around(const Field& field, int x, int y, int far, int apart, const Call& call) {
    const auto first = [&](int position) {
        int from = position - far;
        while (from < 0) from += apart;
        return from;
    };
    for (int v = first(y); v <= std::min(y + far, field.ny() - 1); v += apart)
        for (int u = first(x); u <= std::min(x + far, field.nx() - 1); u += apart) call(u, v);
}

/// Of the slopes around a cell from its own.
struct Differences {
    float most = 0.0F;  // square of the largest
    Products products;
};

/// Adds those of the cells of another row that stand so far aside to those of a row's cells.
void add_differences(std::span<const Rise> row, std::span<const Rise> other, int aside, float dx,
                     float dy, std::vector<Differences>& differences) {
    const auto nx = static_cast<std::ptrdiff_t>(row.size());
    const std::ptrdiff_t end = nx - std::max(aside, 0);
    for (std::ptrdiff_t x = std::max(-aside, 0); x < end; ++x) {
        const Rise& own = row[static_cast<std::size_t>(x)];
        const Rise& beside = other[static_cast<std::size_t>(x + aside)];
        const float east = (beside.east - own.east) / dx;
        const float north = (beside.north - own.north) / dy;
        Differences& sum = differences[static_cast<std::size_t>(x)];
        sum.most = std::max(sum.most, east * east + north * north);
        sum.products.east_east += east * east;
        sum.products.east_north += east * north;
        sum.products.north_north += north * north;
    }
}

Field<Edge> edges(const Field<Rise>& rises, float dx, float dy, WorkerPool& pool) {
    const int nx = rises.nx();
    const int ny = rises.ny();
    Field<Edge> found(nx, ny);
    Field<Products> products(nx, ny);
    pool.for_ranges(ny, [&](int begin, int end) {
        std::vector<Differences> differences(static_cast<std::size_t>(nx));
        for (int y = begin; y < end; ++y) {
            std::fill(differences.begin(), differences.end(), Differences{});
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ny - 1); ++v) {
                for (int aside = -1; aside <= 1; ++aside)
                    add_differences(rises.row(y), rises.row(v), aside, dx, dy, differences);
            }
            for (int x = 0; x < nx; ++x) {
                const Differences& of = differences[static_cast<std::size_t>(x)];
                products(x, y) = of.products;
                const float bend = std::sqrt(of.most);
                const float t = std::clamp((bend - no_edge) / (full_edge - no_edge), 0.0F, 1.0F);
                found(x, y).share = t * t * (3.0F - 2.0F * t);
                found(x, y).most = most_cut * bend * std::min(dx, dy);
            }
        }
    });
    pool.for_ranges(ny, [&](int begin, int end) {
        std::vector<float> beside(static_cast<std::size_t>(nx) + 2);  // shares in a column of three
        for (int y = begin; y < end; ++y) {
            const auto below = found.row(std::max(y - 1, 0));
            const auto own = found.row(y);
            const auto above = found.row(std::min(y + 1, ny - 1));
            for (std::size_t x = 0; x < own.size(); ++x)
                beside[x + 1] = below[x].share + own[x].share + above[x].share;
            for (int x = 0; x < nx; ++x) {
                const float* around = beside.data() + x;
                if (around[0] + around[1] + around[2] == 0.0F) continue;
                Products sum;
                cells_around(products, x, y, looked_around, 2, [&](int u, int v) {
                    sum.east_east += products(u, v).east_east;
                    sum.east_north += products(u, v).east_north;
                    sum.north_north += products(u, v).north_north;
                });
                turn_along(sum, found(x, y));
            }
        }
    });
    return found;
}

/// Of the four cells around a place, the south-western one first, then eastward and northward.
struct Corner {
    float height = 0.0F;
    Rise rise;
    float sharp = 0.0F;
};

/// What the planes of four cells change of a smooth height, at a place some way (0 … 1) east and
/// north of the first, at most so much.
float cut(const std::array<Corner, 4>& corners, float east, float north, float smooth, float most) {
    float lowest = 0.0F;
    float highest = 0.0F;
    float sharp = 0.0F;
    for (std::size_t i = 0; i < 4; ++i) {
        const Corner& corner = corners[i];
        const float from_west = i % 2 == 0 ? east : east - 1.0F;
        const float from_south = i < 2 ? north : north - 1.0F;
        const float plane =
            corner.height + from_west * corner.rise.east + from_south * corner.rise.north - smooth;
        lowest = i == 0 ? plane : std::min(lowest, plane);
        highest = i == 0 ? plane : std::max(highest, plane);
        sharp += corner.sharp * (1.0F - std::abs(from_west)) * (1.0F - std::abs(from_south));
    }
    return sharp * (std::clamp(lowest, 0.0F, most) + std::clamp(highest, -most, 0.0F));
}

/// Makes edges of smooth heights on fine cells.
void cut_edges(const Field<float>& heights, const Field<Rise>& rises, const Field<Edge>& edge,
               int refinement, Field<float>& fine, WorkerPool& pool) {
    const int first =
        refinement / 2;  // fine cell that is the first one beyond a coarse one's middle
    const auto part = [&](int i) {
        return (static_cast<float>(i) + (refinement % 2 == 0 ? 0.5F : 0.0F)) /
               static_cast<float>(refinement);
    };
    pool.for_ranges(heights.ny() - 1, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x + 1 < heights.nx(); ++x) {
                std::array<Corner, 4> corners{};
                float share = 0.0F;
                float most = 0.0F;
                for (int i = 0; i < 4; ++i) {
                    const int u = x + i % 2;
                    const int v = y + i / 2;
                    corners[static_cast<std::size_t>(i)] = {heights(u, v), rises(u, v),
                                                            edge(u, v).share};
                    share = std::max(share, edge(u, v).share);
                    most = std::max(most, edge(u, v).most);
                }
                if (share == 0.0F) continue;
                for (int j = 0; j < refinement; ++j) {
                    for (int i = 0; i < refinement; ++i) {
                        const int u = x * refinement + first + i;
                        const int v = y * refinement + first + j;
                        fine(u, v) += cut(corners, part(i), part(j), fine(u, v), most);
                    }
                }
            }
        }
    });
}

constexpr float averaged_aside = 3.0F;  // cells along an edge to either side

}  // namespace

Field<float> refined_with_brinks(const Field<float>& heights, float dx, float dy, int refinement,
                                 WorkerPool& pool) {
    Field<float> fine = refined(heights, refinement);
    if (refinement == 1) return fine;
    const Field<Rise> rises = smoother_rises(heights, pool);
    const Field<Edge> edge = edges(rises, dx, dy, pool);
    cut_edges(heights, rises, edge, refinement, fine, pool);
    smooth_along_edges(edge, refinement, averaged_aside, fine, pool);
    return fine;
}

}  // namespace fumon
