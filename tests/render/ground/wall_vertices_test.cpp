#include "render/ground/wall_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace fumon {
namespace {

constexpr double ring_width = 4.0;
constexpr int places_a_ring = 8;

/// Of rings along a ray over ground of those heights, seen from 20 above it.
std::vector<RaySample> chosen(const std::function<double(double)>& height) {
    WallVertices walls(1.2);
    walls.begin_ray();
    for (int ring = 10; ring < 40; ++ring) {
        std::vector<RaySample> positions;
        for (int k = 0; k < places_a_ring; ++k) {
            const double radius = ring_width * (ring + (k + 0.5) / places_a_ring);
            const double over = height(radius) - 20.0;
            positions.push_back({radius, over, over / radius});
        }
        const auto highest = std::ranges::max_element(positions, {}, &RaySample::tangent);
        walls.take(positions, static_cast<std::size_t>(highest - positions.begin()));
    }
    return {walls.chosen().begin(), walls.chosen().end()};
}

/// The height of the ground as the places have it.
double drawn(const std::vector<RaySample>& positions, double radius) {
    const auto after = std::ranges::upper_bound(positions, radius, {}, &RaySample::radius);
    const auto before = after - 1;
    const double share = (radius - before->radius) / (after->radius - before->radius);
    return 20.0 + before->over + share * (after->over - before->over);
}

// Where a ring begins must not matter: between two of them lie walls of any length otherwise.
TEST(WallVertices, StandAtTheFootAndTheRimOfAWallWhereverItCrossesARing) {
    for (int step = 0; step < 27; ++step) {
        const double foot = 90.0 + 0.3 * step;
        const auto wall = [&](double radius) {
            return std::clamp(8.0 * (radius - foot), 0.0, 12.0);
        };
        const std::vector<RaySample> positions = chosen(wall);
        ASSERT_EQ(positions.size(), 30U);
        EXPECT_TRUE(std::ranges::is_sorted(positions, {}, &RaySample::radius)) << foot;
        EXPECT_LT(drawn(positions, foot - 0.6), 1.0) << foot;
        EXPECT_NEAR(drawn(positions, foot + 0.75), 6.0, 2.0) << foot;
        EXPECT_GT(drawn(positions, foot + 2.1), 11.0) << foot;
    }
}

TEST(WallVertices, LoseNoCrestThatLooksHigher) {
    for (int step = 0; step < 8; ++step) {
        const double crest = 100.0 + 0.5 * step;
        const auto spire = [&](double radius) {
            const double wall = std::clamp(8.0 * (radius - 98.0), 0.0, 6.0);
            return std::max(wall - 2.0 * std::max(radius - 104.0, 0.0),
                            18.0 - 4.0 * std::abs(radius - crest));
        };
        double highest = -1e9;
        for (const RaySample& position : chosen(spire))
            highest = std::max(highest, position.tangent);
        EXPECT_GT(highest, -2.0 / crest - 0.01) << crest;
    }
}

TEST(WallVertices, LeaveDunesAsTheyAre) {
    const auto dunes = [](double radius) {
        const double along = radius - 17.0 * static_cast<int>(radius / 17.0);
        return std::min(0.65 * along, 0.3 * (17.0 - along));
    };
    const std::vector<RaySample> positions = chosen(dunes);
    for (std::size_t ring = 0; ring < positions.size(); ++ring) {
        double highest = -1e9;
        for (int k = 0; k < places_a_ring; ++k) {
            const double radius =
                ring_width * (10.0 + static_cast<double>(ring) + (k + 0.5) / places_a_ring);
            highest = std::max(highest, (dunes(radius) - 20.0) / radius);
        }
        EXPECT_EQ(positions[ring].tangent, highest) << ring;
    }
}

}  // namespace
}  // namespace fumon
