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
