#include "numerics/tension_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fumon {
namespace {

/// A wave over a lattice, of which a square in the middle is not known.
struct Hole {
    static constexpr int side = 96;
    static constexpr int from = 40;
    static constexpr int to = 56;
    Grid wave{side, side};
    Mask unknown{side, side};

    Hole() {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                wave(x, y) = std::sin(2.0 * std::numbers::pi * (x + 2.0 * y) / side);
                unknown(x, y) = x >= from && x < to && y >= from && y < to ? 1 : 0;
            }
        }
    }
};

TEST(TensionSurface, GoesOnWithValuesAndSlopes) {
    const Hole hole;
    Grid filled = hole.wave;
    for (std::size_t i = 0; i < filled.size(); ++i)
        if (hole.unknown.values()[i] != 0) filled.values()[i] = 99.0;
    fill_in_tension(filled, hole.unknown);
    for (std::size_t i = 0; i < filled.size(); ++i) {
        if (hole.unknown.values()[i] == 0)
            ASSERT_EQ(filled.values()[i], hole.wave.values()[i]);
        else
            ASSERT_NEAR(filled.values()[i], hole.wave.values()[i], 0.1);
    }
    // The slope does not jump at the edge as a membrane's does.
    for (int y = Hole::from + 2; y < Hole::to - 2; ++y) {
        const double bend =
            filled(Hole::from + 1, y) - 2.0 * filled(Hole::from, y) + filled(Hole::from - 1, y);
        EXPECT_LT(std::abs(bend), 0.02) << y;
    }
}

TEST(TensionSurface, LeavesAFieldOfNothingKnown) {
    Grid field(20, 20, 3.0);
    fill_in_tension(field, Mask(20, 20, 1));
    EXPECT_EQ(field, Grid(20, 20, 3.0));
}

TEST(TensionSurface, DistancesGoOverTheEdges) {
    Mask goal(12, 10);
    goal(1, 1) = 1;
    const Field<float> distance = distances_to(goal);
    EXPECT_EQ(distance(1, 1), 0.0F);
    EXPECT_EQ(distance(4, 1), 3.0F);
    EXPECT_EQ(distance(11, 1), 2.0F) << "over the western edge";
    EXPECT_EQ(distance(1, 8), 3.0F) << "over the southern edge";
    EXPECT_NEAR(distance(3, 3), 2.0 * std::numbers::sqrt2, 1e-5);
    EXPECT_NEAR(distance(11, 9), 2.0 * std::numbers::sqrt2, 1e-5) << "over a corner";
}

}  // namespace
}  // namespace fumon
