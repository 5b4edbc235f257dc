#include "files/terrain/geographic.h"

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

// The usual table of the lengths of a degree on WGS84, in kilometres to three places.
TEST(Geographic, DegreeLengthsMatchPublishedOnes) {
    const double table[][3] = {{0, 111.320, 110.574}, {15, 107.550, 110.649}, {30, 96.486, 110.852},
                               {45, 78.847, 111.132}, {-60, 55.800, 111.412}, {75, 28.902, 111.618},
                               {90, 0.000, 111.694}};
    for (const auto& [latitude, east, north] : table) {
        EXPECT_NEAR(degree_lengths(latitude).east, 1000 * east, 0.6) << latitude;
        EXPECT_NEAR(degree_lengths(latitude).north, 1000 * north, 0.6) << latitude;
    }
}

}  // namespace
}  // namespace fumon
