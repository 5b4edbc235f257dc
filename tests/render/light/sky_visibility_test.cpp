#include "render/light/sky_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"
#include "render/light/light_vectors.h"
#include "render/view/repeated_bed.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

Field<float> as_floats(const Grid& grid) {
    Field<float> result(grid.nx(), grid.ny());
    for (std::size_t i = 0; i < grid.size(); ++i)
        result.values()[i] = static_cast<float>(grid.values()[i]);
    return result;
}

TEST(SkyVisibility, APlainSeesAllOfIt) {
    WorkerPool pool(1);
    const Field<float> sky = sky_visibility(Field<float>(20, 13, 4.0F), 1.0F, 1.7F, pool);
    for (const float value : sky.values()) EXPECT_NEAR(value, 1.0F, 2e-5F);
}

/// In an endless V valley with slopes of angle a the sky is what lies between two planes. Seen from
/// the bottom of one slope it spans 90° … 2a − 90° from the normal: (sin 90° − sin(2a − 90°)) / 2 =
/// cos² a.
TEST(SkyVisibility, AnEndlessValley) {
    constexpr int nx = 801;
    constexpr int ny = 1601;
    WorkerPool pool(2);
    for (const double degrees : {20.0, 35.0, 50.0}) {
        const double slope = std::tan(degrees * M_PI / 180.0);
        Field<float> heights(nx, ny);
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x)
                heights(x, y) = static_cast<float>(slope * std::abs(x - nx / 2));
        }
        const Field<float> sky = sky_visibility(heights, 1.0F, 1.0F, pool);
        const double cosine = std::cos(degrees * M_PI / 180.0);
        EXPECT_NEAR(sky(nx / 2 + 4, ny / 2), cosine * cosine, 0.01) << degrees;
        EXPECT_NEAR(sky(nx / 2 - 4, ny / 2), cosine * cosine, 0.01) << degrees;
    }
}

/// Before a long wall of height h at distance d a level cell loses the share (1 − cos θ)/2 of the
/// sky, θ = atan(h/d).
TEST(SkyVisibility, ALongWall) {
    constexpr int nx = 201;
    constexpr int ny = 3001;
    Field<float> heights(nx, ny, 0.0F);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < 60; ++x) heights(x, y) = 30.0F;
    WorkerPool pool(2);
    const Field<float> sky = sky_visibility(heights, 1.0F, 1.0F, pool);
    for (const int distance : {10, 30, 80}) {
        const double horizon = std::atan2(30.0, distance);
        EXPECT_NEAR(sky(59 + distance, ny / 2), 0.5 * (1.0 + std::cos(horizon)), 0.03) << distance;
    }
}

/// Of ground that is level up to a heap and behind it the sweeps look at the heap alone: its light
/// is that of the same ground with a step far beyond the heap's shadow at either end, which is
/// level nowhere from end to end, to the last bit.
TEST(SkyVisibility, LevelGroundAroundAHeapIsWhatItIsAsUnevenGround) {
    constexpr int n = 120;
    WorkerPool pool(1);
    for (const float heap : {3.0F, -3.0F}) {  // or a pit
        Field<float> level(n, 1, 1.0F);
        unsigned noise = 1;
        for (int x = 50; x < 64; ++x) {
            noise = noise * 1664525U + 1013904223U;
            level(x, 0) += heap * (0.5F + static_cast<float>(noise >> 8U) / 16777216.0F);
        }
        Field<float> uneven = level;
        uneven(0, 0) = 0.5F;  // below the ground, so that no cell's horizon is changed but its own
        uneven(n - 1, 0) = 0.5F;
        const Field<float> expected = sky_visibility(uneven, 1.0F, 1.0F, pool);
        const Field<float> found = sky_visibility(level, 1.0F, 1.0F, pool);
        for (int x = 2; x < n - 2; ++x) EXPECT_EQ(found(x, 0), expected(x, 0)) << x;
    }
}

/// Each cell's horizon is the steepest of the lines from it to all others, on a hill of noise where
/// a cell hides none or many of those before it.
TEST(SkyVisibility, ARoughLineAgainstEveryPairOfItsCells) {
    constexpr int n = 301;
    constexpr float dx = 1.5F;
    constexpr float dy = 1.0F;
    Field<float> line(n, 1);
    unsigned noise = 1;
    for (int x = 0; x < n; ++x) {
        noise = noise * 1664525U + 1013904223U;
        line(x, 0) = 30.0F * std::sin(0.02F * static_cast<float>(x)) +
                     3.0F * static_cast<float>(noise >> 8U) / 16777216.0F;
    }
    std::vector<float> padded(n + 2);
    std::copy_n(line.row(0).data(), n, padded.begin() + 1);
    padded.front() = 2.0F * padded[1] - padded[2];
    padded.back() = 2.0F * padded[n] - padded[n - 1];
    std::vector<float> back(n, -1e9F);
    std::vector<float> ahead(n, -1e9F);
    back.front() = ahead.back() = 0.0F;
    for (int x = 0; x < n; ++x) {
        for (int other = 0; other < n; ++other) {
            if (other == x) continue;
            float& tangent = (other < x ? back : ahead)[static_cast<std::size_t>(x)];
            tangent = std::max(
                tangent, (line(other, 0) - line(x, 0)) / static_cast<float>(std::abs(other - x)));
        }
    }
    // The lines of the other directions are single cells, which see all of the sky.
    const auto diagonal_angle = static_cast<float>(std::atan2(dy, dx));
    const float weight = diagonal_angle / static_cast<float>(2.0 * M_PI);
    std::vector<float> expected(n, 1.0F - 2.0F * weight);
    light_vectors::add_sky(padded.data() + 1, n, back.data(), ahead.data(), dx, weight,
                           expected.data());
    light_vectors::multiply_by_normal(
        {line.row(0).data(), padded.data(), line.row(0).data(), 0.5F / dx, 0.0F}, n,
        expected.data());
    WorkerPool pool(1);
    const Field<float> sky = sky_visibility(line, dx, dy, pool);
    for (int x = 0; x < n; ++x)
        EXPECT_NEAR(sky(x, 0), expected[static_cast<std::size_t>(x)], 2e-6F) << x;
}

TEST(SkyVisibility, IsTheSameForAnyNumberOfThreads) {
    const Field<float> heights = as_floats(wavy_bed(131, 97).bed);
    WorkerPool one(1);
    const Field<float> expected = sky_visibility(heights, 1.0F, 1.3F, one);
    for (const int threads : {2, 3, 8}) {
        WorkerPool pool(threads);
        EXPECT_EQ(sky_visibility(heights, 1.0F, 1.3F, pool), expected) << threads;
    }
}

TEST(SkyVisibility, IsTheSameForATurnedBed) {
    const Field<float> heights = as_floats(wavy_bed(60, 60).bed);
    Field<float> turned(60, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) turned(59 - y, x) = heights(x, y);
    WorkerPool pool(1);
    const Field<float> sky = sky_visibility(heights, 1.0F, 1.0F, pool);
    const Field<float> sky_turned = sky_visibility(turned, 1.0F, 1.0F, pool);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) EXPECT_NEAR(sky_turned(59 - y, x), sky(x, y), 1e-5F);
}

TEST(SkyVisibility, NarrowBedsWork) {
    WorkerPool pool(1);
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}}) {
        const Field<float> sky = sky_visibility(Field<float>(nx, ny, 1.0F), 1.0F, 1.0F, pool);
        for (const float value : sky.values()) EXPECT_NEAR(value, 1.0F, 2e-5F);
    }
}

TEST(SkyVisibility, CellsOfAMarginHideTheSkyAndAreLeftOut) {
    Field<float> heights(53, 38);
    for (int y = 0; y < heights.ny(); ++y)
        for (int x = 0; x < heights.nx(); ++x)
            heights(x, y) = static_cast<float>((x * 7 + y * 13) % 11 + (x * x + y) % 5);
    WorkerPool pool(2);
    const Field<float> whole = sky_visibility(heights, 1.0F, 1.3F, pool);
    for (const int margin : {1, 7, 18}) {
        EXPECT_EQ(sky_visibility(heights, 1.0F, 1.3F, pool, margin), without_margin(whole, margin))
            << margin;
    }
}

}  // namespace
}  // namespace fumon
