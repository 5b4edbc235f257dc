#include "render/view/sharp_brinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "render/view/brink_vectors.h"

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

/// What the ground about a cell has of an edge: how much of one, 0 … 1, how much a bicubic may cut
/// off it, and where it runs.
struct Edge {
    float share = 0.0F;
    float most = 0.0F;
    float east = 0.0F;  // a unit vector along it
    float north = 0.0F;
};

/// Sums of products of differences of slope.
struct Products {
    float east_east = 0.0F;
    float east_north = 0.0F;
    float north_north = 0.0F;
};

/// The direction in which slopes differ the least.
Edge edge_along(const Products& sum, float share, float most) {
    const float half = 0.5F * (sum.east_east - sum.north_north);
    const float larger = half + std::sqrt(half * half + sum.east_north * sum.east_north);
    // Across the edge lies (larger, east_north) where slopes differ eastward the most.
    const float east = larger > 0.0F ? -sum.east_north : -1.0F;
    const float length = std::sqrt(larger * larger + east * east);
    return {share, most, east / length, larger / length};
}

Field<Edge> edges(const Field<Rise>& rises, float dx, float dy, WorkerPool& pool) {
    const int nx = rises.nx();
    const int ny = rises.ny();
    Field<Edge> found(nx, ny);
    pool.for_ranges(ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < nx; ++x) {
                float most = 0.0F;  // square of a difference of slope
                Products sum;
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ny - 1); ++v) {
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, nx - 1); ++u) {
                        const float east = (rises(u, v).east - rises(x, y).east) / dx;
                        const float north = (rises(u, v).north - rises(x, y).north) / dy;
                        most = std::max(most, east * east + north * north);
                        sum.east_east += east * east;
                        sum.east_north += east * north;
                        sum.north_north += north * north;
                    }
                }
                const float bend = std::sqrt(most);
                const float t = std::clamp((bend - no_edge) / (full_edge - no_edge), 0.0F, 1.0F);
                found(x, y) =
                    edge_along(sum, t * t * (3.0F - 2.0F * t), most_cut * bend * std::min(dx, dy));
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

/// What edges change of smooth heights, on fine cells.
Field<float> cuts(const Field<float>& heights, const Field<float>& fine, const Field<Rise>& rises,
                  const Field<Edge>& edge, int refinement, WorkerPool& pool) {
    Field<float> changes(fine.nx(), fine.ny());
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
                        changes(u, v) = cut(corners, part(i), part(j), fine(u, v), most);
                    }
                }
            }
        }
    });
    return changes;
}

/// The edges about the fine cells of a coarse row, those of one coarse cell alike.
class EdgesOfRow {
  public:
    explicit EdgesOfRow(int cells) : share_(size(cells)), east_(size(cells)), north_(size(cells)) {}

    /// Whether there is any.
    bool take(const Field<Edge>& edge, int y, int refinement) {
        bool any = false;
        auto share = share_.begin();
        auto east = east_.begin();
        auto north = north_.begin();
        for (const Edge& at : edge.row(y)) {
            any = any || at.share != 0.0F;
            share = std::fill_n(share, refinement, at.share);
            east = std::fill_n(east, refinement, at.east);
            north = std::fill_n(north, refinement, at.north);
        }
        return any;
    }
    [[nodiscard]] brink_vectors::RowOfEdges row() const {
        return {share_.data(), east_.data(), north_.data()};
    }

  private:
    static std::size_t size(int cells) { return static_cast<std::size_t>(cells); }

    std::vector<float> share_;
    std::vector<float> east_;
    std::vector<float> north_;
};

/// Adds to heights what edges change, as its mean over three coarse cells along each edge, which
/// runs on where the lattice breaks it up.
void add_along_edges(const Field<float>& changes, const Field<Edge>& edge, int refinement,
                     Field<float>& fine, WorkerPool& pool) {
    const float step =
        1.5F * static_cast<float>(refinement) / static_cast<float>(brink_vectors::places_aside);
    const std::vector<std::uint64_t> pairs =
        brink_vectors::pairs_of(changes.data(), static_cast<int>(changes.size()));
    pool.for_ranges(edge.ny(), [&](int begin, int end) {
        EdgesOfRow edges(fine.nx());
        for (int y = begin; y < end; ++y) {
            if (!edges.take(edge, y, refinement)) continue;
            for (int v = y * refinement; v < (y + 1) * refinement; ++v)
                brink_vectors::add_means_along({pairs.data(), changes.nx(), changes.ny()}, v,
                                               edges.row(), step, fine.row(v).data());
        }
    });
}

}  // namespace

Field<float> refined_with_brinks(const Field<float>& heights, float dx, float dy, int refinement,
                                 WorkerPool& pool) {
    Field<float> fine = refined(heights, refinement);
    if (refinement == 1) return fine;
    const Field<Rise> rises = smoother_rises(heights, pool);
    const Field<Edge> edge = edges(rises, dx, dy, pool);
    const Field<float> changes = cuts(heights, fine, rises, edge, refinement, pool);
    add_along_edges(changes, edge, refinement, fine, pool);
    return fine;
}

}  // namespace fumon
