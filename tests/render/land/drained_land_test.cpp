#include "render/land/drained_land.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {
namespace {

constexpr int side = 48;

/// Bumps between which there are hollows, periodic.
Grid bumps() {
    Grid field(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            field(x, y) = std::sin(0.7853981634 * x) * std::cos(0.5235987756 * y) +
                          0.3 * std::sin(1.8325957146 * (x + 2 * y));
    return field;
}

/// Cells for which `counts` says so and that have no lower neighbour.
template <class Counts>
int hollows(const Grid& heights, const Counts& counts) {
    int number = 0;
    for (int y = 1; y + 1 < heights.ny(); ++y) {
        for (int x = 1; x + 1 < heights.nx(); ++x) {
            if (!counts(x, y)) continue;
            bool lower = false;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u) lower |= heights(u, v) < heights(x, y);
            if (!lower) ++number;
        }
    }
    return number;
}

TEST(DrainedLand, LeavesNoHollow) {
    Grid heights = bumps();
    Field<LandCell> cells(side, side, LandCell::free);
    for (int y = 20; y < 28; ++y)
        for (int x = 20; x < 28; ++x) cells(x, y) = LandCell::known;
    for (int x = 0; x < side; ++x) {
        cells(x, 0) = LandCell::outlet;
        cells(x, side - 1) = LandCell::known;
        heights(x, 0) = -9.0;
    }
    const Grid before = heights;
    const auto free = [&](int x, int y) { return cells(x, y) == LandCell::free; };
    EXPECT_GT(hollows(heights, free), 5);
    drain(heights, cells, 1.0, 1.0, 1e-4);
    EXPECT_EQ(hollows(heights, free), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells.values()[i] == LandCell::free) continue;
        ASSERT_EQ(heights.values()[i], before.values()[i]);
    }
}

TEST(DrainedLand, IsAsSteepAsAskedAndRepeats) {
    const Grid noise = bumps();
    const SlopeByArea slopes(noise, {}, 2.0, 2.0);
    const DrainedTile tile = drained_tile(noise, slopes, {0.2, 0.3}, 2.0, 2.0, 2.0);
    const auto land = [&](int x, int y) { return tile.rivers(x, y) == 0; };
    EXPECT_EQ(hollows(tile.heights, land), 0);
    EXPECT_NEAR(mean_gradient(tile.heights, tile.rivers, 2.0, 2.0), 0.2, 0.02);
    double across = 0.0;
    double within = 0.0;
    for (int y = 0; y < side; ++y) {
        across = std::max(across, std::abs(tile.heights(0, y) - tile.heights(side - 1, y)));
        for (int x = 1; x < side; ++x)
            within = std::max(within, std::abs(tile.heights(x, y) - tile.heights(x - 1, y)));
    }
    EXPECT_LE(across, 1.1 * within) << "other rows have their steepest places elsewhere";
}

TEST(DrainedLand, TellsSlopesByArea) {
    // A valley whose floor falls by 0.1 and whose sides fall by 0.5.
    Grid valley(41, 60);
    for (int y = 0; y < valley.ny(); ++y)
        for (int x = 0; x < valley.nx(); ++x) valley(x, y) = 0.1 * y + 0.5 * std::abs(x - 20);
    const SlopeByArea slopes(valley, {}, 1.0, 1.0);
    EXPECT_NEAR(slopes.hillslope(), 0.5, 0.06);
    EXPECT_NEAR(slopes.at(800.0), 0.1, 0.02);
    EXPECT_LT(slopes.at(1e6), slopes.at(1e4));
}

}  // namespace
}  // namespace fumon
