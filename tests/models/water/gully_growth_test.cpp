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

/// What runs over a periodic bed: the wavelength of its relief by the rms of heights and slopes, in
/// cells, and the direction across which it runs, degrees counterclockwise from east.
struct Channels {
    double wavelength = 0.0;
    double direction = 0.0;
};

Channels channels_of(const Grid& bed) {
    const int nx = bed.nx();
    const int ny = bed.ny();
    double mean = 0.0;
    for (const double z : bed.values()) mean += z / static_cast<double>(bed.size());
    double squares = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double east = 0.5 * (bed((x + 1) % nx, y) - bed((x + nx - 1) % nx, y));
            const double north = 0.5 * (bed(x, (y + 1) % ny) - bed(x, (y + ny - 1) % ny));
            squares += (bed(x, y) - mean) * (bed(x, y) - mean);
            xx += east * east;
            yy += north * north;
            xy += east * north;
        }
    }
    return {2.0 * std::numbers::pi * std::sqrt(squares / (xx + yy)),
            90.0 / std::numbers::pi * std::atan2(2.0 * xy, xx - yy)};
}

/// Of a plane of slope .04 that descends so many degrees from south toward east, out of noise.
Channels channels_down(double degrees) {
    const double turn = degrees * std::numbers::pi / 180.0;
    GullyParameters gully = as_printed(0.04 * std::cos(turn));
    gully.slope_x = 0.04 * std::sin(turn);
    gully.transport = SedimentTransport::incision;
    gully.scheme = WaterScheme::finite_volume;
    gully.bed_diffusion = 0.02;  // the fastest channels lie eight cells apart
    gully.time_step = 1.0;
    GullyRun run(gully, noise(64, 64, 0.002));
    run.to(200.0);
    return channels_of(run.gully.snapshot().bed);
}

TEST(GullyGrowth, ChannelsDoNotKnowTheGrid) {
    const Channels along = channels_down(0.0);
    const Channels turned = channels_down(30.0);
    EXPECT_NEAR(along.direction, 0.0, 1.0);
    EXPECT_NEAR(turned.direction, 30.0, 2.5);
    EXPECT_NEAR(turned.wavelength / along.wavelength, 1.0, 0.1);
    EXPECT_GT(along.wavelength, 7.0);
}

}  // namespace
}  // namespace fumon::test
