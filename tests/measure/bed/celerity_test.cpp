#include "measure/bed/celerity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "support/measured_beds.h"

namespace fumon {
namespace {

using test::turn;

/// Waves of several lengths moved by a fraction of a site, exactly.
Grid band(double sites) {
    return test::bed_of(128, 12, [=](int x, int y) {
        double height = 0.0;
        for (int k = 7; k <= 13; ++k) {
            height += std::cos(turn * k * (x - sites) / 128.0 + 1.7 * k * k + 0.9 * y * (k - 10));
        }
        return height;
    });
}

TEST(Celerity, OfABedMovedByWholeSites) {
    const Grid bed = test::noise(60, 20, 3);
    for (const int sites : {0, 1, 7, 29, -1, -12, -29}) {
        const Celerity found = celerity_along_x(bed, test::moved(bed, sites), 4);
        EXPECT_NEAR(found.sites_per_step, sites / 4.0, 0.02) << sites;
        EXPECT_NEAR(found.correlation, 1.0, 1e-12);
    }
}

TEST(Celerity, OfABedMovedByAFractionOfASite) {
    for (const double sites : {0.0, 0.25, 0.5, 3.3, -2.75, 17.4}) {
        EXPECT_NEAR(celerity_along_x(band(0.0), band(sites), 1).sites_per_step, sites, 0.02)
            << sites;
    }
}

TEST(Celerity, SurvivesNoise) {
    const Grid before = test::sum(band(0.0), test::noise(128, 12, 1), 4.0);
    const Grid after = test::sum(band(2.5), test::noise(128, 12, 2), 4.0);
    const Celerity found = celerity_along_x(before, after, 1);
    EXPECT_NEAR(found.sites_per_step, 2.5, 0.3);
    EXPECT_LT(found.correlation, 0.9);
}

TEST(Celerity, OfARegularPatternIsTakenForTheShorterWay) {
    // 10 sites a wave: 4 downwind is seen as it is, 6 downwind as 4 upwind.
    const Grid bed = test::waves(100, 5, 10.0);
    EXPECT_NEAR(
        celerity_along_x(bed, test::waves(100, 5, 10.0, 0.0, -0.4 * turn), 2).sites_per_step, 2.0,
        1e-9);
    EXPECT_NEAR(
        celerity_along_x(bed, test::waves(100, 5, 10.0, 0.0, -0.6 * turn), 2).sites_per_step, -2.0,
        1e-9);
}

TEST(Celerity, IsUndefinedBetweenUnrelatedBeds) {
    const Celerity found = celerity_along_x(test::noise(100, 40, 1), test::noise(100, 40, 2), 1);
    EXPECT_TRUE(std::isnan(found.sites_per_step));
    EXPECT_LT(found.correlation, 0.3);
    const Celerity level = celerity_along_x(Grid(10, 3, 0.1), Grid(10, 3, 0.1), 1);
    EXPECT_TRUE(std::isnan(level.sites_per_step));
    EXPECT_TRUE(std::isnan(level.correlation));
}

TEST(Celerity, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(celerity_along_x(Grid(8, 4), Grid(4, 8), 1), Error);
    EXPECT_THROW(celerity_along_x(Grid(8, 4), Grid(8, 4), 0), Error);
}

}  // namespace
}  // namespace fumon
