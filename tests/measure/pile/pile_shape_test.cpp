#include "measure/pile/pile_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fumon {
namespace {

Grid cone(int cells, BedPoint apex, double height, double slope) {
    Grid bed(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x)
            bed(x, y) = std::max(0.0, height - slope * std::hypot(x - apex.x, y - apex.y));
    }
    return bed;
}

TEST(PileShape, CountsGrainsAndCells) {
    Grid bed(4, 3);
    bed(1, 1) = 7.0;
    bed(2, 1) = 4.0;
    bed(1, 2) = 1.0;
    const PileShape shape = pile_shape(bed, {1.0, 1.0});
    EXPECT_EQ(shape.largest_height, 7.0);
    EXPECT_EQ(shape.resident_grains, 12.0);
    EXPECT_EQ(shape.covered_cells, 3);
}

TEST(PileShape, AConeOnTheDropPointHasNoOffset) {
    const PileShape shape = pile_shape(cone(65, {32.0, 32.0}, 45.0, 1.8), {32.0, 32.0});
    EXPECT_NEAR(shape.offset, 0.0, 1e-7);
    EXPECT_NEAR(shape.cone.r_squared, 1.0, 1e-12);
    EXPECT_NEAR(shape.drop_cone.r_squared, 1.0, 1e-12);
    EXPECT_NEAR(shape.axis_ratio, 1.0, 1e-12);
}

struct CentreShift {
    const char* name;
    double east, north, azimuth;
};

class DriftedPile : public ::testing::TestWithParam<CentreShift> {};

TEST_P(DriftedPile, SaysHowFarAndWhereTo) {
    const auto [name, east, north, azimuth] = GetParam();
    const BedPoint drop{32.0, 32.0};
    const PileShape shape = pile_shape(cone(64, {drop.x + east, drop.y + north}, 30.0, 1.8), drop);
    EXPECT_NEAR(shape.offset, std::hypot(east, north), 1e-6);
    EXPECT_NEAR(shape.offset_azimuth, azimuth, 1e-5);
    EXPECT_LT(shape.drop_cone.r_squared, 0.8);
    EXPECT_NEAR(shape.cone.r_squared, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Directions, DriftedPile,
                         ::testing::Values(CentreShift{"NorthEast", 8.0, 8.0, 45.0},
                                           CentreShift{"SouthEast", 7.5, -7.5, 135.0},
                                           CentreShift{"South", 0.25, -9.0, 178.4088597},
                                           CentreShift{"West", -10.0, 0.0, 270.0},
                                           CentreShift{"NorthWest", -5.0, 5.0 * std::sqrt(3.0),
                                                       330.0}),
                         [](const auto& drift) { return drift.param.name; });

TEST(PileShape, ABareBedHasNoShape) {
    const PileShape shape = pile_shape(Grid(16, 16), {8.0, 8.0});
    EXPECT_EQ(shape.largest_height, 0.0);
    EXPECT_EQ(shape.resident_grains, 0.0);
    EXPECT_EQ(shape.covered_cells, 0);
    EXPECT_TRUE(std::isnan(shape.axis_ratio));
    EXPECT_TRUE(std::isnan(shape.drop_cone.r_squared));
    EXPECT_TRUE(std::isnan(shape.cone.r_squared));
    EXPECT_TRUE(std::isnan(shape.offset));
    EXPECT_TRUE(std::isnan(shape.offset_azimuth));
}

TEST(PileShape, ATowerHasHeightButNoCone) {
    Grid bed(16, 16);
    bed(8, 8) = 1000.0;
    const PileShape shape = pile_shape(bed, {8.0, 8.0});
    EXPECT_EQ(shape.largest_height, 1000.0);
    EXPECT_EQ(shape.resident_grains, 1000.0);
    EXPECT_EQ(shape.covered_cells, 1);
    EXPECT_DOUBLE_EQ(shape.axis_ratio, 1.0);  // one square
    EXPECT_TRUE(std::isnan(shape.cone.slope));
    EXPECT_TRUE(std::isnan(shape.offset));
}

TEST(PileShape, TheAxisRatioOfARectangleIsThatOfItsSides) {
    Grid bed(30, 20);
    for (int y = 3; y < 9; ++y) {
        for (int x = 5; x < 20; ++x) bed(x, y) = 1.0;
    }
    EXPECT_NEAR(pile_shape(bed, {15.0, 10.0}).axis_ratio, 6.0 / 15.0, 1e-12);
}

TEST(PileShape, TheAxisRatioOfASlantingEllipseIsThatOfItsAxes) {
    Grid bed(128, 128);
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            const double along = (x - 60.0) * 0.8 + (y - 66.0) * 0.6;
            const double across = (y - 66.0) * 0.8 - (x - 60.0) * 0.6;
            if (std::hypot(along / 50.0, across / 20.0) < 1.0) bed(x, y) = 2.0;
        }
    }
    EXPECT_NEAR(pile_shape(bed, {64.0, 64.0}).axis_ratio, 0.4, 0.005);
}

}  // namespace
}  // namespace fumon
