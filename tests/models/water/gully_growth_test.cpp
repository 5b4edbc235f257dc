// Small cross-slope waves of the bed against linear theory.

#include <gtest/gtest.h>

#include <numbers>

#include "support/gully_run.h"

namespace fumon::test {
namespace {

TEST(GullyGrowth, SingleModesAsPrinted) {
    EXPECT_NEAR(growth_rate(as_printed(), 100, 800, 1000), 0.00321, 0.03 * 0.00321);
    EXPECT_NEAR(growth_rate(as_printed(), 50, 800, 1000), 0.00329, 0.03 * 0.00329);
    EXPECT_NEAR(growth_rate(as_printed(), 25, 600, 800), -0.00249, 0.03 * 0.00249);
}

TEST(GullyGrowth, TheDispersionRelationHolds) {
    GullyParameters gully = as_printed();
    gully.transport = SedimentTransport::incision;
    for (const int wavelength : {100, 50, 25}) {
        const double theory = linear_growth_rate(gully, wavelength);
        EXPECT_NEAR(growth_rate(gully, wavelength, 800, 1000), theory, 0.03 * std::fabs(theory))
            << wavelength;
    }
}

/// On cells of 4 m the upwinding of finite volumes levels the water across waves of 10 cells at .42
/// of the rate at which gravity does, on cells of 1 m at .11: central differences alone miss that.
TEST(GullyGrowth, UpwindingLevelsWaterAcrossShortWaves) {
    constexpr int cells = 10;
    constexpr double slope = 0.04;
    GullyParameters gully = as_printed(slope);
    gully.transport = SedimentTransport::incision;
    gully.scheme = WaterScheme::finite_volume;
    gully.bed_diffusion = 0.0;
    const double speed =
        std::sqrt(gully.gravity * gully.depth * slope / gully.friction_coefficient);
    const double erosion = 0.5 * gully.velocity_exponent *
                           std::pow(speed, gully.velocity_exponent) *
                           std::pow(slope, gully.slope_exponent) / gully.depth;
    const double water =
        gully.gravity * gully.depth * gully.depth / (gully.friction_coefficient * speed);
    const double phase = 2.0 * std::numbers::pi / cells;
    for (const double cell : {1.0, 4.0}) {
        const double by_gravity = water * std::pow(std::sin(phase) / cell, 2);
        const double by_upwinding = 2.0 * std::sqrt(gully.gravity * gully.depth) *
                                    std::pow(std::sin(0.5 * phase), 4) / cell;
        const auto growth = [&](double levelled) {
            return 0.5 * (std::sqrt(levelled * levelled + 4.0 * erosion * levelled) - levelled);
        };
        const double measured = growth_rate(gully, cells, 100, 160, cell);
        EXPECT_NEAR(measured / growth(by_gravity + by_upwinding), 1.0, 0.02) << cell;
        EXPECT_NEAR(measured / growth(by_gravity), cell > 1.0 ? 1.17 : 1.03, 0.02) << cell;
    }
}

TEST(GullyGrowth, WavesShorterThanTheCutoffDecayAndLongerOnesGrow) {
    GullyParameters gully = as_printed();
    gully.transport = SedimentTransport::incision;
    const double flux = std::pow(std::sqrt(9.8 * 0.04), 1.8) * std::pow(0.04, 2.1);
    const double cutoff = 2.0 * std::numbers::pi / std::sqrt(0.9 * flux / 0.01);
    EXPECT_NEAR(cutoff, 29.6, 0.1);
    EXPECT_LT(growth_rate(gully, 27, 600, 800), 0.0);
    EXPECT_GT(growth_rate(gully, 33, 600, 800), 0.0);
}

TEST(GullyGrowth, ConservativeTransportFillsInAtEverySlope) {
    for (const double slope : {0.005, 0.04}) {
        GullyParameters gully = as_printed(slope);
        gully.transport = SedimentTransport::conservative;
        EXPECT_LT(growth_rate(gully, 100, 300, 400), 0.0) << slope;
    }
}

}  // namespace
}  // namespace fumon::test
