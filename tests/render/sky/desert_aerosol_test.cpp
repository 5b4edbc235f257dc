#include "render/sky/desert_aerosol.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

/// Contrast of dark things against the horizon falls as exp(−3.912 d / V) in green light.
TEST(DesertAerosol, LeavesTwoHundredthsOfContrastWithinItsVisibility) {
    for (const double kilometres : {2.0, 16.0, 100.0, 1000.0}) {
        const glm::dvec3 extinction = desert_aerosol::extinction(kilometres, 1.0);
        EXPECT_NEAR(std::exp(-extinction.g * kilometres), 0.02, 1e-4) << kilometres;
        EXPECT_NEAR(std::exp(-extinction.g * 5.0), std::exp(-3.912 * 5.0 / kilometres), 1e-12);
    }
}

TEST(DesertAerosol, DimsBlueLightTheMostAndDustAllAlike) {
    const glm::dvec3 clear = desert_aerosol::extinction(desert_aerosol::visibility(1.0), 1.0);
    EXPECT_GT(clear.b, 1.1 * clear.g);
    EXPECT_LT(clear.r, 0.95 * clear.g);
    const glm::dvec3 dusty = desert_aerosol::extinction(desert_aerosol::visibility(40.0), 40.0);
    EXPECT_LT(dusty.b, 1.04 * dusty.g);
    // Molecules alone: the fourth power of the wavelength.
    const glm::dvec3 clean = desert_aerosol::extinction(desert_aerosol::visibility(0.0), 0.0);
    EXPECT_NEAR(clean.b / clean.g, std::pow(550.0 / 465.0, 4.0), 1e-6);
}

/// The haze before far dunes is the air that the sky is made of.
TEST(DesertAerosol, IsTheSkysOwnNearTheGround) {
    for (const double dust : {0.0, 0.5, 1.0, 2.0, 20.0}) {
        const AirOptics sky = desert_air(dust, glm::dvec3(0.3)).optics(0.0);
        const double seen = desert_aerosol::visibility(dust);
        EXPECT_NEAR(sky.extinction().g, desert_aerosol::extinction(seen, dust).g, 1e-9) << dust;
        for (int band = 0; band < 3; ++band)
            EXPECT_LE(sky.mie[band], 0.97 * sky.mie_extinction[band]) << "some is absorbed";
    }
    EXPECT_DOUBLE_EQ(desert_aerosol::visibility(1.0), desert_aerosol::clear_visibility);
    EXPECT_LT(desert_aerosol::visibility(20.0), 0.4 * desert_aerosol::clear_visibility);
}

TEST(DesertAerosol, IsThinnerFromAbove) {
    EXPECT_EQ(desert_aerosol::thinner_from(0.0), 1.0);
    EXPECT_EQ(desert_aerosol::thinner_from(-0.1), 1.0);
    for (const double u : {0.3, 1.0, 3.0}) {
        EXPECT_NEAR(desert_aerosol::thinner_from(u * desert_aerosol::height),
                    (1.0 - std::exp(-u)) / u, 0.012)
            << u;
    }
}

}  // namespace
}  // namespace fumon
