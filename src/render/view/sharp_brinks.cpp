#include "render/view/sharp_brinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/worker_pool.h"
#include "numerics/resampling.h"

namespace fumon {

namespace {

constexpr float no_edge = 0.2F;  // differences of slope
constexpr float full_edge = 0.45F;
constexpr float most_cut = 0.25F;  // of an edge's height, over a cell, that a smooth surface cuts off

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
    return std::abs(bend_before) <= std::abs(bend_after) ? before + 0.5F * bend_before
                                                         : after - 0.5F * bend_after;
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

/// How far the ground about each cell has an edge, 0 … 1.
Field<float> edges(const Field<Rise>& rises, float dx, float dy, WorkerPool& pool) {
    const int nx = rises.nx();
    const int ny = rises.ny();
    Field<float> sharp(nx, ny);
    pool.for_ranges(ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < nx; ++x) {
                float most = 0.0F;  // square of a difference of slope
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ny - 1); ++v) {
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, nx - 1); ++u) {
                        const float east = (rises(u, v).east - rises(x, y).east) / dx;
                        const float north = (rises(u, v).north - rises(x, y).north) / dy;
                        most = std::max(most, east * east + north * north);
                    }
                }
                const float t =
                    std::clamp((std::sqrt(most) - no_edge) / (full_edge - no_edge), 0.0F, 1.0F);
                sharp(x, y) = t * t * (3.0F - 2.0F * t);
            }
        }
    });
    return sharp;
}

/// Of the four cells around a place, the south-western one first, then eastward and northward.
struct Corner {
    float height = 0.0F;
    Rise rise;
    float sharp = 0.0F;
};

/// What the planes of four cells change of a smooth height, at a place some way (0 … 1) east and north of
/// the first.
float cut(const std::array<Corner, 4>& corners, float east, float north, float smooth,
          float least_side) {
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
    const float most = most_cut * least_side;
    return sharp * (std::clamp(lowest, 0.0F, most) + std::clamp(highest, -most, 0.0F));
}

}  // namespace

Field<float> refined_with_brinks(const Field<float>& heights, float dx, float dy, int refinement,
                                 WorkerPool& pool) {
    Field<float> fine = refined(heights, refinement);
    if (refinement == 1) return fine;
    const Field<Rise> rises = smoother_rises(heights, pool);
    const Field<float> sharp = edges(rises, dx, dy, pool);
    const float least_side = std::min(dx, dy);
    const int first = refinement / 2;  // fine cell that is the first one beyond a coarse one's middle
    const auto part = [&](int i) {
        return (static_cast<float>(i) + (refinement % 2 == 0 ? 0.5F : 0.0F)) /
               static_cast<float>(refinement);
    };
    pool.for_ranges(heights.ny() - 1, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x + 1 < heights.nx(); ++x) {
                std::array<Corner, 4> corners{};
                float most = 0.0F;
                for (int i = 0; i < 4; ++i) {
                    const int u = x + i % 2;
                    const int v = y + i / 2;
                    corners[static_cast<std::size_t>(i)] = {heights(u, v), rises(u, v),
                                                            sharp(u, v)};
                    most = std::max(most, sharp(u, v));
                }
                if (most == 0.0F) continue;
                for (int j = 0; j < refinement; ++j) {
                    for (int i = 0; i < refinement; ++i) {
                        float& height =
                            fine(x * refinement + first + i, y * refinement + first + j);
                        height += cut(corners, part(i), part(j), height, least_side);
                    }
                }
            }
        }
    });
    return fine;
}

}  // namespace fumon
