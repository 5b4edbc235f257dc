#include "measure/water/channels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/water/channel_bed.h"
#include "measure/water/thalweg.h"
#include "support/measured_beds.h"

namespace fumon::test {
namespace {

/// Water of 0.01 m with channels of 10 % of that at the given columns, which wander by `swing`
/// cells once along y.
Grid channelled(int nx, int ny, const std::vector<double>& columns, double swing = 0.0) {
    return bed_of(nx, ny, [&](int x, int y) {
        double depth = 0.01;
        for (const double column : columns) {
            const double middle = column + swing * std::sin(turn * y / ny);
            const double away = std::remainder(x - middle, nx);
            depth += 0.001 * std::exp(-0.5 * away * away / 16.0);
        }
        return depth;
    });
}

Grid northward_mirrored(const Grid& field) {
    return bed_of(field.nx(), field.ny(),
                  [&](int x, int y) { return field(x, field.ny() - 1 - y); });
}

Grid eastward_mirrored(const Grid& field) {
    return bed_of(field.nx(), field.ny(),
                  [&](int x, int y) { return field(field.nx() - 1 - x, y); });
}

TEST(Channels, AreCountedAndPlacedInMetres) {
    const Grid depth = channelled(100, 40, {10.0, 40.0, 70.0});
    const Channels channels = find_channels(depth, {}, 2.0, true);
    EXPECT_EQ(channels.sites, (std::vector{10, 40, 70}));
    EXPECT_EQ(channels.count, 3.0);
    EXPECT_NEAR(channels.spacing, 200.0 / 3.0, 1e-12);
    EXPECT_NEAR(channels.mean_distance, 200.0 / 3.0, 1e-12);
    EXPECT_NEAR(channels.positions[1], 81.0, 0.01);
    const double variation = std::sqrt((2 * 60.0 * 60.0 + 80.0 * 80.0) / 3 - 40000.0 / 9) / 200 * 3;
    EXPECT_NEAR(channels.distance_variation, variation, 1e-3);
    const Channels walled = find_channels(depth, {}, 2.0, false);
    EXPECT_EQ(walled.count, 3.0);
    EXPECT_NEAR(walled.mean_distance, 60.0, 0.01) << "from the first to the last";
}

TEST(Channels, CountTheSameMovedMirroredAndOfAnyHeight) {
    const Grid water = noise(96, 30, 7);
    const Channels channels = find_channels(water, {}, 1.0, true);
    ASSERT_GT(channels.count, 1.0);
    EXPECT_EQ(find_channels(northward_mirrored(water), {}, 1.0, true).sites, channels.sites);
    EXPECT_EQ(find_channels(eastward_mirrored(water), {}, 1.0, true).count, channels.count);
    for (const int sites : {1, 37, 90})
        EXPECT_EQ(find_channels(moved(water, sites), {}, 1.0, true).count, channels.count) << sites;
    const Grid thin = bed_of(96, 30, [&](int x, int y) { return 0.01 + 1e-7 * water(x, y); });
    EXPECT_EQ(find_channels(thin, {}, 1.0, true).sites, channels.sites);
}

TEST(Channels, AreNoneInRoundingAndNoneBelowAQuarterOfTheRange) {
    EXPECT_EQ(find_channels(Grid(50, 20, 0.01), {}, 1.0, true).count, 0.0);
    const Grid rounding =
        bed_of(50, 20, [](int x, int) { return 0.01 + 1e-13 * std::cos(turn * x / 25); });
    EXPECT_EQ(find_channels(rounding, {}, 1.0, true).count, 0.0);
    EXPECT_TRUE(std::isnan(find_channels(rounding, {}, 1.0, true).spacing));
    const auto two = [](double second) {
        return bed_of(120, 5, [=](int x, int) {
            const auto hill = [&](double middle) {
                return std::exp(-0.5 * (x - middle) * (x - middle) / 25.0);
            };
            return 1.0 + hill(30.0) + second * hill(90.0);
        });
    };
    EXPECT_EQ(find_channels(two(0.26), {}, 1.0, true).count, 2.0);
    EXPECT_EQ(find_channels(two(0.24), {}, 1.0, true).count, 1.0);
}

TEST(Channels, CellsWithoutDataDoNotCount) {
    Grid depth = channelled(100, 40, {10.0, 40.0, 70.0});
    Mask nodata(100, 40);
    for (int y = 0; y < 39; ++y) {
        depth(55, y) = 9.0;
        nodata(55, y) = 1;
    }
    EXPECT_EQ(find_channels(depth, nodata, 1.0, true).count, 3.0);
    nodata(55, 39) = 1;
    EXPECT_TRUE(std::isnan(find_channels(depth, nodata, 1.0, true).count));
}

TEST(Thalweg, AStraightChannelHasSinuosityOneAskewOrNot) {
    const Grid straight = channelled(60, 80, {30.0});
    EXPECT_NEAR(mean_sinuosity(straight, std::vector{30}, 1.0, 1.0, true), 1.0, 1e-9);
    const Grid askew = bed_of(60, 80, [](int x, int y) {
        const double away = x - 20.0 - 0.25 * y;
        return 0.01 + 0.001 * std::exp(-0.5 * away * away / 16.0);
    });
    EXPECT_NEAR(mean_sinuosity(askew, std::vector{30}, 1.0, 1.0, false), 1.0, 1e-3);
}

TEST(Thalweg, AWindingChannelIsAsLongAsItsSine) {
    constexpr double swing = 8.0;
    constexpr int rows = 100;
    double length = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double slope = swing * turn / rows * std::cos(turn * i / 10000);
        length += std::sqrt(1.0 + slope * slope) / 10000;
    }
    const Grid depth = channelled(100, rows, {50.0}, swing);
    const double found = mean_sinuosity(depth, std::vector{50}, 3.0, 3.0, true);
    EXPECT_NEAR(found - 1.0, length - 1.0, 0.04 * (length - 1.0));
    EXPECT_NEAR(mean_sinuosity(moved(depth, 50), std::vector{0}, 3.0, 3.0, true), found, 1e-12)
        << "round the edge";
    EXPECT_NEAR(mean_sinuosity(eastward_mirrored(depth), std::vector{49}, 3.0, 3.0, true), found,
                1e-12);
    EXPECT_NEAR(mean_sinuosity(depth, std::vector{50}, 3.0, 6.0, true) - 1.0, (found - 1.0) / 4.0,
                0.1 * (found - 1.0) / 4.0)
        << "half as steep bends";
}

TEST(Thalweg, WindowsMeetHalfWay) {
    const std::vector<int> sites{10, 40, 90};
    const auto round = channel_windows(sites, 100, true);
    EXPECT_EQ(round[0].first, 1);
    EXPECT_EQ(round[0].last, 24);
    EXPECT_EQ(round[1].first, 26);
    EXPECT_EQ(round[2].last, 99);
    const auto walled = channel_windows(sites, 100, false);
    EXPECT_EQ(walled[0].first, 0);
    EXPECT_EQ(walled[2].last, 99);
    const auto alone = channel_windows(std::vector{20}, 100, true);
    EXPECT_EQ(alone[0].first, -29);
    EXPECT_EQ(alone[0].last, 69);
}

/// A trough of Gaussian depth 0.02 m and width 4 cells with rims of 0.003 m on both sides, `apart`
/// cells away.
Grid trough(double far_bed, double middle, double apart = 30.0) {
    return bed_of(100, 12, [=](int x, int) {
        const double away = std::remainder(x - middle, 100.0);
        const double rim = std::abs(away) - apart;
        return far_bed - 0.02 * std::exp(-away * away / 32.0) +
               0.003 * std::exp(-0.5 * rim * rim / 4.0);
    });
}

TEST(ChannelBed, IsMeasuredAgainstTheBedFarAway) {
    for (const double far_bed : {0.0, -0.5}) {
        for (const double middle : {50.0, 3.0}) {
            const ChannelBed bed = channel_bed(trough(far_bed, middle), {}, 1.0, true);
            EXPECT_NEAR(bed.far_bed, far_bed, 1e-9);
            EXPECT_NEAR(bed.lowest, -0.02, 1e-9);
            EXPECT_NEAR(bed.rim, 0.003, 1e-4);
            EXPECT_EQ(bed.position, middle + 0.5);
        }
    }
    for (const double apart : {38.0, 41.0}) {
        const ChannelBed wide = channel_bed(trough(-0.5, 50.0, apart), {}, 1.0, true);
        EXPECT_NEAR(wide.rim, 0.003, 6e-4) << "rims " << apart << " cells away";
    }
    const ChannelBed level = channel_bed(Grid(100, 12, 0.3), {}, 1.0, true);
    EXPECT_TRUE(std::isnan(level.lowest));
    const Grid plain = bed_of(
        100, 12, [](int x, int) { return -0.02 * std::exp(-(x - 50.0) * (x - 50.0) / 32.0); });
    EXPECT_EQ(channel_bed(plain, {}, 1.0, true).rim, 0.0) << "no rim";
}

}  // namespace
}  // namespace fumon::test
