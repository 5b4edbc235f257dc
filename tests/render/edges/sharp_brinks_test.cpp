#include "render/edges/sharp_brinks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/grid.h"
#include "base/worker_pool.h"
#include "numerics/resampling.h"

namespace fumon {
namespace {

constexpr int coarse = 40;
constexpr int refinement = 4;

/// Where a fine cell lies among coarse ones.
float position(int fine) {
    return (static_cast<float>(fine) + 0.5F) / refinement - 0.5F;
}

/// A stoss slope of 0.05 that ends at a slip face of 0.65, whose brink runs some way across the
/// lattice.
float stoss_and_slip_face(float x, float y, float eastward, float northward) {
    const float across = eastward * (x - 19.3F) + northward * (y - 20.1F);
    return std::min(3.0F + 0.05F * across, 3.0F - 0.65F * across);
}

bool same(const Field<float>& one, const Field<float>& other) {
    return std::ranges::equal(one.values(), other.values());
}

/// How far the line where ground falls at a slope of 0.16 eastward strays across a brink, coarse
/// cells.
float strays(const Field<float>& fine, float eastward, float northward) {
    constexpr float falls = -0.16F;
    float least = 1e6F;
    float most = -1e6F;
    for (int y = 10 * refinement; y < 30 * refinement; ++y) {
        const auto slope = [&](int x) {
            return 0.5F * refinement * (fine(x + 1, y) - fine(x - 1, y));
        };
        int x = 1;
        while (slope(x + 1) > falls) ++x;
        const float share = (slope(x) - falls) / (slope(x) - slope(x + 1));
        const float across =
            eastward * (position(x) + share / refinement) + northward * position(y);
        least = std::min(least, across);
        most = std::max(most, across);
    }
    return most - least;
}

float farthest_from_brink(const Field<float>& fine, float eastward, float northward) {
    float farthest = 0.0F;
    for (int y = 10 * refinement; y < 30 * refinement; ++y) {
        for (int x = 10 * refinement; x < 30 * refinement; ++x) {
            const float exact = stoss_and_slip_face(position(x), position(y), eastward, northward);
            farthest = std::max(farthest, std::abs(fine(x, y) - exact));
        }
    }
    return farthest;
}

TEST(SharpBrinks, ABrinkThatSandRoundsRunsStraightAcrossTheLattice) {
    WorkerPool pool(2);
    for (const float degrees : {5.0F, 14.0F, 20.0F, 30.0F}) {
        const float eastward = std::cos(degrees / 57.29578F);
        const float northward = std::sin(degrees / 57.29578F);
        Field<float> heights(coarse, coarse);
        for (int y = 0; y < coarse; ++y) {
            for (int x = 0; x < coarse; ++x) {
                float sum = 0.0F;  // over a cell
                for (int i = 0; i < 16; ++i) {
                    const float aside = 0.25F * (static_cast<float>(i % 4) - 1.5F);
                    const float ahead = 0.25F * (static_cast<float>(i / 4) - 1.5F);
                    sum += stoss_and_slip_face(static_cast<float>(x) + aside,
                                               static_cast<float>(y) + ahead, eastward, northward);
                }
                heights(x, y) = sum / 16.0F;
            }
        }
        const Field<float> fine = refined_with_brinks(heights, 1.0F, 1.0F, refinement, pool);
        EXPECT_LT(strays(fine, eastward, northward), 0.12F) << degrees;
    }
}

TEST(SharpBrinks, ABrinkBetweenCellsStaysAnEdge) {
    WorkerPool pool(2);
    for (const float degrees : {0.0F, 17.0F, 45.0F, 70.0F}) {
        const float eastward = std::cos(degrees / 57.29578F);
        const float northward = std::sin(degrees / 57.29578F);
        Field<float> heights(coarse, coarse);
        for (int y = 0; y < coarse; ++y) {
            for (int x = 0; x < coarse; ++x) {
                heights(x, y) = stoss_and_slip_face(static_cast<float>(x), static_cast<float>(y),
                                                    eastward, northward);
            }
        }
        const float smooth = farthest_from_brink(refined(heights, refinement), eastward, northward);
        const float sharp = farthest_from_brink(
            refined_with_brinks(heights, 1.0F, 1.0F, refinement, pool), eastward, northward);
        EXPECT_GT(smooth, 0.05F) << degrees;
        EXPECT_LT(sharp, 0.6F * smooth) << degrees;
    }
}

TEST(SharpBrinks, SmoothGroundIsAsItWasAndTheFootOfASlipFaceIsAnEdge) {
    WorkerPool pool(1);
    Field<float> dome(coarse, coarse);
    Field<float> foot(coarse, coarse);
    for (int y = 0; y < coarse; ++y) {
        for (int x = 0; x < coarse; ++x) {
            dome(x, y) = 2.0F * std::cos(0.15F * static_cast<float>(x)) *
                         std::cos(0.13F * static_cast<float>(y));
            foot(x, y) = std::max(0.0F, 0.65F * (static_cast<float>(x) - 20.4F));
        }
    }
    const Field<float> smooth = refined(dome, refinement);
    const Field<float> drawn = refined_with_brinks(dome, 1.0F, 1.0F, refinement, pool);
    for (int y = 6 * refinement; y < 34 * refinement; ++y)
        for (int x = 6 * refinement; x < 34 * refinement; ++x) EXPECT_EQ(drawn(x, y), smooth(x, y));
    const Field<float> fine = refined_with_brinks(foot, 1.0F, 1.0F, refinement, pool);
    const int row = 20 * refinement;
    for (int x = 19 * refinement; x < 22 * refinement; ++x)
        EXPECT_NEAR(fine(x, row), std::max(0.0F, 0.65F * (position(x) - 20.4F)), 0.02F) << x;
}

TEST(SharpBrinks, AreTheSameOnAnyNumberOfThreads) {
    Field<float> heights(coarse, coarse);
    for (int y = 0; y < coarse; ++y) {
        for (int x = 0; x < coarse; ++x) {
            heights(x, y) = stoss_and_slip_face(static_cast<float>(x), static_cast<float>(y),
                                                std::cos(0.04F * static_cast<float>(y)), 0.3F);
        }
    }
    WorkerPool one(1);
    WorkerPool three(3);
    EXPECT_TRUE(same(refined_with_brinks(heights, 1.0F, 1.0F, 3, one),
                     refined_with_brinks(heights, 1.0F, 1.0F, 3, three)));
}

}  // namespace
}  // namespace fumon
