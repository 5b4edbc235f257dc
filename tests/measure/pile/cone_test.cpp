#include "measure/pile/cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace fumon {
namespace {

/// max(0, height − slope · r) on nx × ny cells.
Grid cone(int nx, int ny, BedPoint apex, double height, double slope) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            bed(x, y) = std::max(0.0, height - slope * std::hypot(x - apex.x, y - apex.y));
    }
    return bed;
}

struct Place {
    const char* name;
    BedPoint apex;
};

class ExactCone : public ::testing::TestWithParam<Place> {};

TEST_P(ExactCone, IsFoundWithItsApex) {
    const BedPoint apex = GetParam().apex;
    const ConeFit found = free_cone(cone(48, 40, apex, 20.0, 1.6));
    EXPECT_NEAR(found.apex.x, apex.x, 1e-7);
    EXPECT_NEAR(found.apex.y, apex.y, 1e-7);
    EXPECT_NEAR(found.height, 20.0, 1e-6);
    EXPECT_NEAR(found.slope, 1.6, 1e-7);
    EXPECT_NEAR(found.angle, std::atan(1.6) * 180.0 / std::acos(-1.0), 1e-6);
    EXPECT_NEAR(found.r_squared, 1.0, 1e-12);
}

TEST_P(ExactCone, IsFoundByAConeAtItsApex) {
    const BedPoint apex = GetParam().apex;
    const ConeFit found = cone_at(cone(48, 40, apex, 20.0, 1.6), apex);
    EXPECT_NEAR(found.height, 20.0, 1e-10);
    EXPECT_NEAR(found.slope, 1.6, 1e-11);
    EXPECT_NEAR(found.r_squared, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Places, ExactCone,
                         ::testing::Values(Place{"OnACell", {24.0, 20.0}},
                                           Place{"BetweenCells", {23.37, 20.81}},
                                           Place{"OffCentre", {14.25, 26.5}},
                                           Place{"CutOffByOneEdge", {3.6, 18.2}},
                                           Place{"CutOffByTwoEdges", {44.9, 37.3}}),
                         [](const auto& place) { return place.param.name; });

TEST(FreeCone, FillsTheBoxUpToEveryEdge) {
    const BedPoint apex{6.5, 8.25};
    const ConeFit found = free_cone(cone(16, 16, apex, 60.0, 2.0));  // covers every cell
    EXPECT_NEAR(found.apex.x, apex.x, 1e-7);
    EXPECT_NEAR(found.apex.y, apex.y, 1e-7);
    EXPECT_NEAR(found.slope, 2.0, 1e-7);
}

TEST(FreeCone, IsFoundUnderNoise) {
    const BedPoint apex{36.4, 27.7};
    Grid bed = cone(64, 64, apex, 45.0, 1.8);
    RandomStream noise(1, 0, 0, Purpose::initial_bed);
    double squares = 0.0;
    double mean = 0.0;
    int covered = 0;
    for (double& height : bed.values()) {
        if (height == 0.0) continue;
        mean += height;
        ++covered;
    }
    mean /= covered;
    double variance = 0.0;
    for (double& height : bed.values()) {
        if (height == 0.0) continue;
        variance += (height - mean) * (height - mean);
        const double error = std::sqrt(12.0) * (noise.uniform() - 0.5);  // standard deviation 1
        squares += error * error;
        height = std::max(1e-3, height + error);
    }
    // Standard error of the apex: 1 / (1.8 √(cells / 2)) = 0.018 cells.
    const ConeFit found = free_cone(bed);
    EXPECT_NEAR(found.apex.x, apex.x, 0.06);
    EXPECT_NEAR(found.apex.y, apex.y, 0.06);
    EXPECT_NEAR(found.slope, 1.8, 0.02);
    EXPECT_NEAR(found.r_squared, 1.0 - squares / (squares + variance), 0.003);
}

TEST(FreeCone, HeightsInWholeGrainsMoveTheApexLittle) {
    const BedPoint apex{30.2, 33.6};
    Grid bed = cone(64, 64, apex, 45.0, 1.8);
    for (double& height : bed.values()) height = std::floor(height);
    const ConeFit found = free_cone(bed);
    EXPECT_NEAR(found.apex.x, apex.x, 0.05);
    EXPECT_NEAR(found.apex.y, apex.y, 0.05);
    EXPECT_NEAR(found.slope, 1.8, 0.03);
    EXPECT_GT(found.r_squared, 0.998);
}

TEST(FreeCone, FitsNoWorseThanAConeAnywhereElse) {
    Grid bed = cone(32, 32, {20.0, 12.0}, 14.0, 1.1);
    bed(4, 28) = 6.0;  // what no cone explains
    bed(20, 12) += 9.0;
    const ConeFit best = free_cone(bed);
    for (double y = 8.0; y <= 16.0; y += 0.5) {
        for (double x = 16.0; x <= 24.0; x += 0.5)
            EXPECT_LE(cone_at(bed, {x, y}).r_squared, best.r_squared + 1e-12) << x << ' ' << y;
    }
}

TEST(ConeAt, IsTheStraightLineThroughCoveredCells) {
    Grid bed(9, 1);  // worked out by hand: h = 5, 2, 3 at r = 0, 1, 3
    bed(2, 0) = 5.0;
    bed(3, 0) = 2.0;
    bed(5, 0) = 3.0;
    const ConeFit found = cone_at(bed, {2.0, 0.0});
    EXPECT_NEAR(found.slope, 0.5, 1e-14);
    EXPECT_NEAR(found.height, 4.0, 1e-14);
    EXPECT_NEAR(found.r_squared, 0.25, 1e-14);
}

TEST(ConeAt, BesideTheApexFitsBadly) {
    const Grid bed = cone(64, 64, {39.0, 23.0}, 45.0, 1.8);
    EXPECT_LT(cone_at(bed, {32.0, 32.0}).r_squared, 0.6);
    EXPECT_NEAR(free_cone(bed).r_squared, 1.0, 1e-12);
}

TEST(ConeAt, DoesNotDependOnTheBareGroundAround) {
    const ConeFit narrow = cone_at(cone(24, 24, {12.0, 12.0}, 9.5, 1.0), {11.0, 12.0});
    const ConeFit wide = cone_at(cone(96, 96, {12.0, 12.0}, 9.5, 1.0), {11.0, 12.0});
    EXPECT_DOUBLE_EQ(narrow.r_squared, wide.r_squared);
    EXPECT_DOUBLE_EQ(narrow.slope, wide.slope);
}

TEST(ConeAt, ABowlHasANegativeSlope) {
    Grid bed(21, 21);
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 21; ++x) bed(x, y) = 1.0 + 0.5 * std::hypot(x - 10, y - 10);
    }
    EXPECT_NEAR(cone_at(bed, {10.0, 10.0}).slope, -0.5, 1e-12);
    EXPECT_NEAR(free_cone(bed).slope, -0.5, 1e-7);
    EXPECT_LT(free_cone(bed).angle, 0.0);
}

void expect_no_cone(const ConeFit& fit) {
    EXPECT_TRUE(std::isnan(fit.apex.x));
    EXPECT_TRUE(std::isnan(fit.apex.y));
    EXPECT_TRUE(std::isnan(fit.height));
    EXPECT_TRUE(std::isnan(fit.slope));
    EXPECT_TRUE(std::isnan(fit.angle));
    EXPECT_TRUE(std::isnan(fit.r_squared));
}

TEST(Cones, DoNotExistInABareBed) {
    expect_no_cone(cone_at(Grid(16, 16), {8.0, 8.0}));
    expect_no_cone(free_cone(Grid(16, 16)));
}

TEST(Cones, DoNotExistInATower) {
    Grid bed(16, 16);
    bed(8, 8) = 1000.0;
    expect_no_cone(cone_at(bed, {8.0, 8.0}));
    expect_no_cone(free_cone(bed));
}

TEST(Cones, DoNotExistInAPlateau) {
    Grid bed(16, 16);
    for (int y = 4; y < 12; ++y) {
        for (int x = 3; x < 13; ++x) bed(x, y) = 7.0;
    }
    expect_no_cone(cone_at(bed, {8.0, 8.0}));
    expect_no_cone(free_cone(bed));
}

TEST(Cones, DoNotExistWhereAllCellsAreAsFar) {
    Grid bed(5, 5);
    bed(1, 2) = 1.0;
    bed(3, 2) = 2.0;
    bed(2, 1) = 3.0;
    bed(2, 3) = 4.0;
    expect_no_cone(cone_at(bed, {2.0, 2.0}));
}

TEST(FreeCone, DoesNotExistOnATiltedPlane) {
    Grid bed(20, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) bed(x, y) = 1.0 + 0.5 * x;
    }
    expect_no_cone(free_cone(bed));
}

TEST(FreeCone, OfAPileOneCellWideLiesOnIt) {
    Grid bed(21, 1);
    for (int x = 0; x < 21; ++x) bed(x, 0) = std::max(0.0, 8.0 - std::abs(x - 9.5));
    const ConeFit found = free_cone(bed);
    EXPECT_NEAR(found.apex.x, 9.5, 1e-6);
    EXPECT_NEAR(found.apex.y, 0.0, 1e-6);
    EXPECT_NEAR(found.slope, 1.0, 1e-6);
}

}  // namespace
}  // namespace fumon
