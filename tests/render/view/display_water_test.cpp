#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "render/view/block.h"
#include "render/view/water.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

DisplayWater displayed_water(const Snapshot& snapshot, int refinement) {
    WorkerPool pool(2);
    return display_water(snapshot, refinement, pool);
}

/// A V-shaped valley, steeper in the west, that falls southward by a tenth, a stream in its lowest
/// column and rain's film on its flanks.
Snapshot stream_in_a_valley() {
    Snapshot valley = under_water(flat_bed(21, 40), 0.0005, 0.0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 21; ++x)
            valley.bed(x, y) = (x < 10 ? 0.8 * (10 - x) : 0.3 * (x - 10)) + 0.1 * y;
        valley.fields[0].values(10, y) = 0.15;
    }
    return valley;
}

TEST(DisplayWater, LiesLevelAcrossAChannelOfOneCell) {
    const DisplayWater water = displayed_water(stream_in_a_valley(), 1);
    EXPECT_NEAR(water.slope_x(10, 20), 0.0F, 1e-6F);
    EXPECT_NEAR(water.slope_y(10, 20), 0.1F, 1e-5F);
    EXPECT_NEAR(water.slope_x(9, 20), 0.0F, 1e-6F);  // its bank's film does not tilt it
    const DisplayWater sheet = displayed_water(
        [] {
            Snapshot plane = under_water(flat_bed(20, 20), 0.1, 0.0);
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x) plane.bed(x, y) = 0.3 * x;
            return plane;
        }(),
        1);
    EXPECT_NEAR(sheet.slope_x(10, 10), 0.3F, 1e-5F);
    EXPECT_NEAR(sheet.slope_x(0, 10), 0.3F, 1e-5F);
}

// Else its four flanks mirror four parts of the sky: a star.
TEST(DisplayWater, ABumpOfOneCellHardlyTiltsTheSurface) {
    Snapshot pond = under_water(flat_bed(20, 20), 0.5, 0.0);
    pond.fields[0].values(10, 10) += 0.06;
    const DisplayWater water = displayed_water(pond, 1);
    EXPECT_GT(*std::ranges::max_element(water.slope_x.values()), 0.001F);
    EXPECT_LT(*std::ranges::max_element(water.slope_x.values()), 0.01F);  // 0.03 by differences
}

TEST(DisplayWater, AStreamDoesNotClimbItsBanksBetweenCells) {
    // A channel of one cell that falls by 0.2 a cell, two centimetres deep, between walls of 1.2.
    constexpr int finer = 8;
    Snapshot valley = under_water(flat_bed(21, 40), 0.0, 0.0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 21; ++x)
            valley.bed(x, y) = 0.2 * y + 1.2 * std::min(1, std::abs(x - 10));
        valley.fields[0].values(10, y) = 0.02;
    }
    const DisplayWater water = displayed_water(valley, finer);
    const float closes = static_cast<float>(closed_depth(valley.scale));
    int widest = 0;
    for (int y = 10 * finer; y < 30 * finer; ++y) {
        int width = 0;
        for (int x = 8 * finer; x < 13 * finer; ++x) width += water.depth(x, y) > closes ? 1 : 0;
        widest = std::max(widest, width);
        EXPECT_GT(water.depth(10 * finer + finer / 2, y), closes) << "unbroken, at row " << y;
    }
    EXPECT_LE(widest, finer * 3 / 4) << "of a cell, not up the walls";
}

// Between interpolated banks the depth of the middle alone would be a line a tenth of a cell wide.
TEST(DisplayWater, WaterInAChannelOfOneCellIsAsMuchAsTheCellHas) {
    // It falls by a hundredth a cell, less than the water is deep, between walls of 1.
    constexpr int finer = 8;
    Snapshot gully = under_water(flat_bed(21, 40), 0.0, 0.0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 21; ++x)
            gully.bed(x, y) = 0.01 * y + 1.0 * std::min(3, std::abs(x - 10));
        gully.fields[0].values(10, y) = 0.06;
    }
    const DisplayWater water = displayed_water(gully, finer);
    const auto closes = static_cast<float>(closed_depth(gully.scale));
    for (int y = 10 * finer; y < 30 * finer; ++y) {
        int width = 0;
        for (int x = 8 * finer; x < 13 * finer; ++x) width += water.depth(x, y) > closes ? 1 : 0;
        EXPECT_GE(width, finer / 2) << "as wide as its water needs, at row " << y;
        EXPECT_LE(width, finer * 3 / 4) << "not up the walls, at row " << y;
    }
}

TEST(DisplayWater, EndsWhereItsLevelMeetsTheGround) {
    // A pond to level 1.6 before a bank of 45 degrees, on which there is a film of half a
    // millimetre.
    constexpr int finer = 8;
    Snapshot pond = under_water(flat_bed(20, 12), 0.0005, 0.0);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 20; ++x) {
            pond.bed(x, y) = std::max(0.0, x - 8.3);
            if (pond.bed(x, y) < 1.6) pond.fields[0].values(x, y) = 1.6 - pond.bed(x, y);
        }
    }
    const DisplayWater water = displayed_water(pond, finer);
    Field<float> bed(20, 12);
    std::copy(pond.bed.values().begin(), pond.bed.values().end(), bed.values().begin());
    const Field<float> ground = refined(bed, finer);
    const int middle = 6 * finer;
    for (int x = 9 * finer; x < 18 * finer; ++x) {
        const double above = 1.6 - static_cast<double>(ground(x, middle));
        if (above > 0.02) {
            EXPECT_NEAR(water.depth(x, middle), above, 0.02) << x;
        } else if (above < -0.02) {
            EXPECT_LT(water.depth(x, middle), 0.0011) << x;
        }
    }
    // A film on a slope follows it, however far its surface falls within a cell.
    const DisplayWater stream = displayed_water(stream_in_a_valley(), finer);
    for (int x = 2 * finer; x < 8 * finer; ++x)
        EXPECT_NEAR(stream.depth(x, 20 * finer), 0.0005F, 1e-5F) << x;
}

TEST(DisplayWater, ShoresLieBetweenCells) {
    // A pond to level 1 before a dry bank, whose shore runs aslant to the grid.
    constexpr int finer = 2;
    Snapshot pond = under_water(flat_bed(30, 30), 0.0, 0.0);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 30; ++x) {
            pond.bed(x, y) = 0.2 * (x + 0.3 * y) - 3.0;
            pond.fields[0].values(x, y) = std::max(1.0 - pond.bed(x, y), 0.0);
        }
    }
    const Field<float> depth = displayed_water(pond, finer).depth;
    for (int y = 10; y < 50; ++y) {
        int x = 2;
        while (depth(x, y) > 0.0F) ++x;
        ASSERT_GT(depth(x - 1, y) - depth(x, y), 0.0F);
        const float shore =
            static_cast<float>(x) - 1.0F + depth(x - 1, y) / (depth(x - 1, y) - depth(x, y));
        // In coarse cells, whose middles are whole numbers: x + 0.3 y = 20.
        const double in_cells = (static_cast<double>(shore) + 0.5) / finer - 0.5;
        EXPECT_NEAR(in_cells, 20.0 - 0.3 * ((y + 0.5) / finer - 0.5), 0.05) << y;
    }
}

TEST(WaterClarity, FollowsTheDepths) {
    const LookSettings look;
    const WaterStatistics film = water_statistics(under_water(flat_bed(50, 50), 0.01, 0.6));
    EXPECT_NEAR(film.high_depth, 0.01, 1e-6);
    EXPECT_NEAR(film.median_froude, 0.6 / std::sqrt(9.8 * 0.01), 1e-4);
    EXPECT_NEAR(water_clarity(look, film), 0.04, 1e-5);
    EXPECT_NEAR(water_clarity(look, {2.0, 0.2, 0.0}), 1.2, 1e-3);
    EXPECT_GT(water_clarity(look, water_statistics(flat_bed(9, 9))), 0.0);
    LookSettings chosen;
    chosen.water_clarity = {"", 0.3};
    EXPECT_EQ(water_clarity(chosen, film), 0.3);
}

TEST(WaterRelief, AFilmsChannelsAreExaggeratedAndKeepTheirRoom) {
    Snapshot film = under_water(flat_bed(100, 100), 0.01, 0.6);
    const double exaggeration = automatic_exaggeration(film);
    EXPECT_EQ(exaggeration, 50.0);  // the first to make 4 % of 100 m from ten depths
    EXPECT_EQ(automatic_exaggeration(flat_bed(100, 100)), 1.0);
    EXPECT_EQ(automatic_exaggeration(under_water(flat_bed(100, 100), 2.0, 1.0)), 1.0);
    const Block block = frame_block(film, exaggeration);
    EXPECT_LT(block.base, block.z(1.0 - 0.05));
    EXPECT_GT(block.base, -0.2);
}

TEST(DisplayWater, RainWetsTheGroundForAnHour) {
    Snapshot dry = under_water(flat_bed(8, 6), 0.0, 0.0);
    dry.rain = [](double from, double until) {  // of 36 mm/h, from 100 s until 1000 s
        const double seconds = std::clamp(until, 100.0, 1000.0) - std::clamp(from, 100.0, 1000.0);
        return Grid(1, 1, 1e-5 * seconds);
    };
    const auto dampness = [&](double time) {
        dry.time = time;
        return displayed_water(dry, 2).damp(5, 4);
    };
    EXPECT_EQ(dampness(100.0), 0.0F);
    EXPECT_NEAR(dampness(150.0), 0.75 * (1.0 - std::exp(-1.0)), 1e-6);
    EXPECT_NEAR(dampness(1000.0), 0.75, 1e-3);
    EXPECT_GT(dampness(4000.0), 0.7F);
    EXPECT_EQ(dampness(4600.0), 0.0F);
    dry.scale.in_metres = false;
    EXPECT_EQ(dampness(1000.0), 0.0F);
}

}  // namespace
}  // namespace fumon
