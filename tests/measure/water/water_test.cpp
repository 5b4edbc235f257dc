#include <gtest/gtest.h>

#include <cmath>

#include "measure/water/water_flow.h"
#include "measure/water/water_relief.h"
#include "support/measured_beds.h"

namespace fumon::test {
namespace {

TEST(WaterRelief, AStripeIsWhollyExplainedAndNoiseIsNot) {
    const Grid stripes =
        bed_of(64, 50, [](int x, int) { return 0.01 + 0.0001 * std::cos(turn * x / 16); });
    EXPECT_NEAR(downslope_invariant_share(stripes, {}), 1.0, 1e-12);
    const Grid bars =
        bed_of(64, 50, [](int, int y) { return 0.01 + 0.0001 * std::cos(turn * y / 25); });
    EXPECT_NEAR(downslope_invariant_share(bars, {}), 0.0, 1e-12);
    EXPECT_NEAR(downslope_invariant_share(sum(stripes, bars, 1.0), {}), 0.5, 1e-12)
        << "half of the variance each";
    EXPECT_NEAR(downslope_invariant_share(noise(400, 50, 1), {}), 1.0 / 50, 0.15 / 50);
    EXPECT_TRUE(std::isnan(downslope_invariant_share(Grid(9, 9, 0.01), {})));
}

TEST(WaterRelief, ShareDoesNotDependOnPlaceOrAmplitude) {
    const Grid water = noise(60, 40, 3);
    const double share = downslope_invariant_share(water, {});
    EXPECT_NEAR(downslope_invariant_share(moved(water, 17), {}), share, 1e-14);
    const Grid faint = bed_of(60, 40, [&](int x, int y) { return 0.01 + 1e-6 * water(x, y); });
    EXPECT_NEAR(downslope_invariant_share(faint, {}), share, 1e-9);
}

TEST(WaterRelief, OfAWaveIsThatOfASine) {
    const Grid wave = bed_of(60, 7, [](int x, int) { return 2.0 + 0.5 * std::cos(turn * x / 20); });
    const Unevenness all = unevenness(wave, {});
    EXPECT_NEAR(all.mean, 2.0, 1e-14);
    EXPECT_NEAR(all.deviation, 0.5 / std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(all.range, 1.0, 1e-14);
    EXPECT_NEAR(downslope_unevenness(wave, {}).deviation, all.deviation, 1e-14);
    Mask nodata(60, 7);
    nodata(0, 0) = 1;
    Grid spoiled = wave;
    spoiled(0, 0) = 99.0;
    EXPECT_NEAR(unevenness(spoiled, nodata).range, 1.0, 1e-14);
    EXPECT_NEAR(downslope_unevenness(spoiled, nodata).range, 1.0, 1e-14);
    EXPECT_TRUE(std::isnan(unevenness(wave, Mask(60, 7, 1)).mean));
}

TEST(WaterFlow, OfAUniformFilmIsItsOwn) {
    const Grid depth(30, 20, 0.01);
    const WaterFlow flow = water_flow({depth, Grid(30, 20, 0.3), Grid(30, 20, -0.4)}, {}, 9.8);
    EXPECT_NEAR(flow.downslope_flux, 0.004, 1e-15);
    EXPECT_NEAR(flow.mean_flux, 0.005, 1e-15);
    EXPECT_NEAR(flow.largest_flux, 0.005, 1e-15);
    EXPECT_NEAR(flow.mean_speed, 0.5, 1e-14);
    EXPECT_NEAR(flow.mean_froude_number, 0.5 / std::sqrt(0.098), 1e-12);
    EXPECT_EQ(flow.wet_share, 1.0);
    EXPECT_EQ(flow.supercritical_share, 1.0);
}

TEST(WaterFlow, DryCellsHaveNoSpeedAndCellsWithoutDataNothing) {
    Grid depth(4, 1, 0.0);
    Grid u(4, 1, 0.0);
    Grid v(4, 1, 0.0);
    depth(0, 0) = 0.1;
    v(0, 0) = -2.0;  // Froude number 2.02
    depth(1, 0) = 1.0;
    u(1, 0) = 1.0;  // 0.32
    depth(2, 0) = 0.5 * wet_depth;
    u(2, 0) = 50.0;
    depth(3, 0) = 7.0;
    v(3, 0) = -70.0;
    Mask nodata(4, 1);
    nodata(3, 0) = 1;
    const WaterFlow flow = water_flow({depth, u, v}, nodata, 9.8);
    EXPECT_NEAR(flow.wet_share, 2.0 / 3, 1e-15);
    EXPECT_EQ(flow.supercritical_share, 0.5);
    EXPECT_EQ(flow.largest_speed, 2.0);
    EXPECT_EQ(flow.mean_speed, 1.5);
    EXPECT_EQ(flow.largest_flux, 1.0);
    EXPECT_NEAR(flow.downslope_flux, 0.2 / 3, 1e-15);
    const WaterFlow dry = water_flow({Grid(4, 1), u, v}, {}, 9.8);
    EXPECT_EQ(dry.wet_share, 0.0);
    EXPECT_TRUE(std::isnan(dry.mean_speed));
}

}  // namespace
}  // namespace fumon::test
