#include "files/geographic.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

GridExtent extent(double west, double south, double cell, double columns, double rows,
                  double relief) {
    return {west, south, cell * columns, cell * rows, cell, cell, relief};
}

TEST(Geographic, RecognisesDegreeGrids) {
    EXPECT_TRUE(is_geographic(extent(-105.55, 40.09, 1.0 / 1200, 240, 144, 1500)));  // SRTM 3"
    EXPECT_TRUE(is_geographic(extent(5.0, 52.0, 1.0 / 3600, 3600, 3600, 30)));  // Dutch tile, 1"
    EXPECT_TRUE(is_geographic(extent(-0.0005, 51, 1.0 / 1200, 1201, 1201, 100)));
    EXPECT_TRUE(is_geographic(extent(138.0, 36.0, 9e-6, 200, 200, 0.5)));       // 1 m lidar
    EXPECT_TRUE(is_geographic(extent(-180.0, -90.0, 0.25, 1440, 720, 17000)));  // the globe
    EXPECT_TRUE(is_geographic(extent(0.0, -90.0, 1.0, 360, 180, 17000)));
    EXPECT_TRUE(is_geographic(extent(-180.5, -90.5, 1.0, 361, 181, 17000)));  // cell centres
    EXPECT_TRUE(is_geographic(extent(6.0, 0.0, 1.0 / 1200, 1200, 1200, 2000)));
}

TEST(Geographic, LeavesMetricGridsAlone) {
    EXPECT_FALSE(is_geographic(extent(0, 0, 0.001, 1000, 500, 0.08)));      // laboratory bed
    EXPECT_FALSE(is_geographic(extent(3.0, -0.5, 0.005, 1000, 200, 0.3)));  // part of a flume
    EXPECT_FALSE(is_geographic(extent(0, 0, 0.01, 100, 100, 20)));        // model heights, 1 m box
    EXPECT_FALSE(is_geographic(extent(559705, 4380220, 3, 43, 89, 20)));  // UTM
    EXPECT_FALSE(is_geographic(extent(100, 50, 1, 90, 30, 45)));          // local survey
    EXPECT_FALSE(is_geographic(extent(0, 0, 1, 16, 16, 19)));             // a sandpile
    EXPECT_FALSE(is_geographic(extent(100, 95, 0.5, 50, 50, 900)));       // beyond the pole
    EXPECT_FALSE(is_geographic(extent(10, 10, 0.01, 50, 50, 0)));         // flat
}

// The quarter meridian and equator of WGS84 as published: 10,001,965.729 m and 10,018,754.171 m.
TEST(Geographic, DegreeLengthsAddUpToThePublishedMeridian) {
    double meridian = 0.0;
    constexpr int steps = 90 * 16;
    for (int i = 0; i < steps; ++i) meridian += degree_lengths((i + 0.5) * 90.0 / steps).north;
    EXPECT_NEAR(meridian * 90.0 / steps, 10001965.729, 0.05);
    EXPECT_NEAR(degree_lengths(0).east * 90.0, 10018754.171, 0.001);
}

// Tables of the length of a degree on WGS84, rounded there to centimetres or metres.
TEST(Geographic, DegreeLengthsMatchPublishedOnes) {
    EXPECT_NEAR(degree_lengths(0).east, 111319.49, 0.01);
    EXPECT_NEAR(degree_lengths(0).north, 110574.27, 0.05);
    EXPECT_NEAR(degree_lengths(45).east, 78846.81, 0.05);
    EXPECT_NEAR(degree_lengths(45).north, 111131.77, 0.05);
    EXPECT_NEAR(degree_lengths(-60).east, 55800.0, 0.05);
    EXPECT_NEAR(degree_lengths(-60).north, 111412.27, 0.05);
    EXPECT_NEAR(degree_lengths(90).east, 0.0, 0.05);
    EXPECT_NEAR(degree_lengths(90).north, 111693.86, 0.1);
}

}  // namespace
}  // namespace fumon
