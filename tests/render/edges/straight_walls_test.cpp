#include "render/edges/straight_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/grid.h"
#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "render/view/repeated_bed.h"

namespace fumon {
namespace {

constexpr int cells = 64;
constexpr float high = 12.0F;

float cosine(float degrees) {
    return std::cos(degrees / 57.29578F);
}
float sine(float degrees) {
    return std::sin(degrees / 57.29578F);
}

/// A table of rock with a wall that runs some way across the lattice, through cell (32, 32); what
/// lies beyond an edge of the bed is no part of it.
Field<float> table(float degrees) {
    Field<float> heights(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const float across = cosine(degrees) * static_cast<float>(y - 32) -
                                 sine(degrees) * static_cast<float>(x - 32);
            heights(x, y) = across > 0.3F ? high : 0.0F;
        }
    }
    return heights;
}

Field<float> drawn(const Field<float>& heights, int refinement) {
    WorkerPool pool(2);
    const Field<float> fine =
        without_margin(refined(with_margin(heights, 4), refinement), 4 * refinement);
    const auto straight = with_straight_walls(heights, fine, 1.0F, 1.0F, pool);
    return straight ? straight->fine : fine;
}

float height_at(const Field<float>& fine, float x, float y) {
    const int west = static_cast<int>(x);
    const int south = static_cast<int>(y);
    const float right = x - static_cast<float>(west);
    const float upper = y - static_cast<float>(south);
    const float low = fine(west, south) + right * (fine(west + 1, south) - fine(west, south));
    const float over =
        fine(west, south + 1) + right * (fine(west + 1, south + 1) - fine(west, south + 1));
    return low + upper * (over - low);
}

/// How far the line where the wall has a height strays from a straight one, coarse cells.
float wall_strays(const Field<float>& fine, float degrees, float height) {
    const auto refinement = static_cast<float>(fine.nx()) / static_cast<float>(cells);
    float least = 1e6F;
    float most = -1e6F;
    for (int step = -60; step < 60; ++step) {
        const float along = 0.2F * static_cast<float>(step);
        const auto above = [&](float across) {
            const float x = 32.0F + along * cosine(degrees) - across * sine(degrees);
            const float y = 32.0F + along * sine(degrees) + across * cosine(degrees);
            return height_at(fine, (x + 0.5F) * refinement - 0.5F, (y + 0.5F) * refinement - 0.5F) >
                   height;
        };
        float across = -4.0F;
        while (across < 4.0F && !above(across)) across += 0.02F;
        least = std::min(least, across);
        most = std::max(most, across);
    }
    return most - least;
}

TEST(StraightWalls, RunStraightAcrossTheLattice) {
    for (const int refinement : {1, 3}) {
        for (const float degrees : {10.0F, 14.0F, 20.0F, 30.0F, 40.0F}) {
            const Field<float> heights = table(degrees);
            const Field<float> fine = drawn(heights, refinement);
            EXPECT_GT(wall_strays(heights, degrees, 0.5F * high), 0.6F) << degrees << " as it was";
            for (const float height : {1.0F, 6.0F, 11.0F})
                EXPECT_LT(wall_strays(fine, degrees, height), refinement == 1 ? 0.55F : 0.3F)
                    << degrees << ", " << height;
        }
    }
}

TEST(StraightWalls, StandBetweenTheHeightsOfTheirFootAndRim) {
    for (const float degrees : {0.0F, 20.0F, 45.0F}) {
        const Field<float> fine = drawn(table(degrees), 3);
        const auto [lowest, highest] = std::ranges::minmax(fine.values());
        EXPECT_GE(lowest, -1e-4F) << degrees;
        EXPECT_LE(highest, high + 1e-4F) << degrees;
    }
}

// Not a pixel of dunes may change.
TEST(StraightWalls, AreOfRockAlone) {
    Field<float> dunes(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x)
            dunes(x, y) =
                std::min(0.2F * static_cast<float>(x), 1.45F * static_cast<float>(63 - x));
    }
    WorkerPool pool(1);
    EXPECT_FALSE(with_straight_walls(dunes, dunes, 1.0F, 1.0F, pool).has_value());
}

// Their heights tell where they are.
TEST(StraightWalls, AreNoSlopesThatGoOn) {
    Field<float> slope(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x)
            slope(x, y) = std::clamp(3.0F * static_cast<float>(std::abs(x - 32) - 10), 0.0F, 36.0F);
    }
    WorkerPool pool(1);
    EXPECT_FALSE(with_straight_walls(slope, slope, 1.0F, 1.0F, pool).has_value());
}

TEST(StraightWalls, LeaveGroundAwayFromThemAsItIs) {
    Field<float> heights = table(20.0F);
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            heights(x, y) += 0.3F * std::sin(static_cast<float>(x + 2 * y));
    const Field<float> fine = drawn(heights, 1);
    for (int y = 0; y < cells; ++y) {
        for (int x = 10; x < cells - 10; ++x) {
            const float across = cosine(20.0F) * static_cast<float>(y - 32) -
                                 sine(20.0F) * static_cast<float>(x - 32);
            if (std::abs(across) < 7.0F || y < 8 || y > cells - 8) continue;
            EXPECT_EQ(fine(x, y), heights(x, y)) << x << ", " << y;
        }
    }
}

TEST(StraightWalls, AreTheSameOnAnyNumberOfThreadsAndWhereverTheBedBegins) {
    const Field<float> heights = table(20.0F);
    WorkerPool one(1);
    WorkerPool three(3);
    const auto first = with_straight_walls(heights, heights, 1.0F, 1.0F, one);
    const auto second = with_straight_walls(heights, heights, 1.0F, 1.0F, three);
    const Field<float> shifted = rolled(heights, 11, 5);
    const auto third = with_straight_walls(shifted, shifted, 1.0F, 1.0F, three);
    ASSERT_TRUE(first && second && third);
    EXPECT_TRUE(std::ranges::equal(first->fine.values(), second->fine.values()));
    const Field<float> expected = rolled(first->fine, 11, 5);
    for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_NEAR(third->fine.values()[i], expected.values()[i], 1e-4F) << i;
}

}  // namespace
}  // namespace fumon
