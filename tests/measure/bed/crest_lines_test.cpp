#include "measure/bed/crest_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measure/bed/crest_orientation.h"
#include "measure/bed/row_crests.h"
#include "support/measured_beds.h"

namespace fumon {
namespace {

using test::turn;

constexpr double degrees = 180.0 / 3.141592653589793;

// ---- orientation ----

TEST(CrestOrientation, OfTransverseWavesIsZero) {
    const CrestOrientation found = crest_orientation(test::waves(96, 40, 8.0), true);
    EXPECT_NEAR(found.degrees, 0.0, 1e-9);
    EXPECT_NEAR(found.coherence, 1.0, 1e-9);
}

TEST(CrestOrientation, OfTiltedWavesIsTheirAngle) {
    for (int tilt = -5; tilt <= 5; ++tilt) {
        // The normal of the crests is the wave vector (8/96, tilt/60).
        const Grid bed = test::waves(96, 60, 8.0, tilt);
        const double angle = degrees * std::atan2(tilt / 60.0, 8.0 / 96.0);
        const CrestOrientation found = crest_orientation(bed, true);
        EXPECT_NEAR(found.degrees, angle, 0.15) << tilt;
        EXPECT_NEAR(found.coherence, 1.0, 1e-6);
        EXPECT_NEAR(crest_orientation(bed, false).degrees, angle, 0.5) << tilt;
    }
}

TEST(CrestOrientation, OfCrestsAlongTheWindIsNinety) {
    const Grid bed = test::bed_of(40, 60, [](int, int y) { return std::sin(turn * y / 12.0); });
    EXPECT_NEAR(std::abs(crest_orientation(bed, true).degrees), 90.0, 1e-9);
}

TEST(CrestOrientation, OfNoiseIsIncoherent) {
    EXPECT_LT(crest_orientation(test::noise(200, 200, 2), true).coherence, 0.05);
}

TEST(CrestOrientation, IsUndefinedWithoutRelief) {
    EXPECT_TRUE(std::isnan(crest_orientation(Grid(30, 30, 0.1), true).degrees));
    EXPECT_TRUE(std::isnan(crest_orientation(test::waves(30, 4, 2.0), true).degrees));
}

// ---- crests of a row ----

TEST(RowCrests, AreThoseThatFallFarEnough) {
    const std::vector<double> row = {0, 4, 3.5, 5, 1, 2, 0, 3, 3, 0};
    std::vector<double> crests;
    find_row_crests(row, true, 2.0, crests);
    ASSERT_EQ(crests.size(), 2U);
    EXPECT_NEAR(crests[0], 3.0, 0.5);
    EXPECT_NEAR(crests[1], 7.5, 1e-12);
    find_row_crests(row, true, 0.4, crests);
    EXPECT_EQ(crests.size(), 4U);
    find_row_crests(row, true, 6.0, crests);
    EXPECT_TRUE(crests.empty());
}

TEST(RowCrests, AreNotLostAtThePeriodicEdge) {
    for (int sites = 0; sites < 20; ++sites) {
        const Grid row = test::moved(test::waves(20, 1, 1.0), sites);
        std::vector<double> crests;
        find_row_crests(row.row(0), true, 1.0, crests);
        ASSERT_EQ(crests.size(), 1U) << sites;
        find_row_crests(row.row(0), false, 1.0, crests);
        EXPECT_LE(crests.size(), 1U);
    }
}

// ---- lines and their ends ----

TEST(CrestDefects, OfWavesWithoutEndsAreNone) {
    for (int tilt = -5; tilt <= 5; ++tilt) {
        const CrestDefects found = crest_defects(test::waves(96, 60, 8.0, tilt), true, 12.0);
        EXPECT_EQ(found.ends, 0) << tilt;
        EXPECT_EQ(found.defect_density, 0.0);
        // Eight crests, each as long as the box over the cosine of its turn.
        const double length = 8 * 60.0 * std::hypot(1.0, tilt * 12.0 / 60.0);
        EXPECT_NEAR(found.crest_length, length, 0.01 * length) << tilt;
        EXPECT_EQ(crest_defects(test::waves(96, 60, 8.0, tilt), false, 12.0).ends, 0) << tilt;
    }
    EXPECT_EQ(crest_defects(test::waves(96, 60, 8.0), true, 12.0).lines, 8);
}

/// Waves with one crest more in the rows between y = south and y = north: the phase winds by a turn
/// about either point at `x0`. Periodic in x; in y as far as the points lie from the edge.
Grid with_pair(int nx, int ny, double waves, double x0, double south, double north) {
    return test::bed_of(nx, ny, [=](int x, int y) {
        const auto winding = [&](double y0) {
            const double east = 0.5 * turn * (x - x0) / nx;
            const double up = 0.5 * turn * (y - y0) / nx;
            return std::atan2(std::cos(east) * std::sinh(up), std::sin(east) * std::cosh(up));
        };
        return std::cos(turn * waves * x / nx + winding(north) - winding(south));
    });
}

TEST(CrestDefects, OfAnInsertedCrestAreItsTwoEnds) {
    const Grid bed = with_pair(96, 192, 8.0, 40.3, 60.4, 130.6);
    for (const double wavelength : {9.0, 12.0, 16.0}) {
        const CrestDefects found = crest_defects(bed, true, wavelength);
        EXPECT_EQ(found.ends, 2) << wavelength;
        EXPECT_NEAR(found.crest_length, 8 * 192.0 + 70.0, 30.0);
        EXPECT_NEAR(found.defect_density, 1.0 / found.crest_length, 1e-15);
        EXPECT_NEAR(found.ends_per_square_wavelength, 2.0 * wavelength * wavelength / (96 * 192),
                    1e-12);
    }
}

TEST(CrestDefects, AreCountedWhereverTheBedBegins) {
    const Grid bed = with_pair(96, 192, 8.0, 40.3, 60.4, 130.6);
    for (int sites = 0; sites < 96; sites += 11) {
        EXPECT_EQ(crest_defects(test::moved(bed, sites), true, 12.0).ends, 2) << sites;
    }
}

TEST(CrestDefects, SurviveNoise) {
    const Grid rough = test::noise(96, 192, 5);  // its deviation is 0.29, that of the waves 0.71
    EXPECT_EQ(
        crest_defects(test::sum(with_pair(96, 192, 8.0, 40.3, 60.4, 130.6), rough), true, 12.0)
            .ends,
        2);
    EXPECT_EQ(crest_defects(test::sum(test::waves(96, 192, 8.0, 2.0), rough), true, 12.0).ends, 0);
}

TEST(CrestDefects, OfSeparateDunesAreTwoEach) {
    const Grid bed = test::bed_of(100, 100, [](int x, int y) {
        const auto dune = [&](double x0, double y0) {
            return std::exp(-0.02 * (x - x0) * (x - x0) - 0.01 * (y - y0) * (y - y0));
        };
        return dune(20, 30) + dune(60, 45) + dune(40, 75);
    });
    const CrestDefects found = crest_defects(bed, true, 30.0);
    EXPECT_EQ(found.lines, 3);
    EXPECT_EQ(found.ends, 6);
    EXPECT_NEAR(found.defect_density, 3.0 / found.crest_length, 1e-15);
}

TEST(CrestDefects, SpecksAreNoCrests) {
    Grid bed(96, 60);
    for (int y = 10; y < 40; ++y) {
        for (int x = 20; x < 26; ++x) bed(x, y) = 1.0;
    }
    EXPECT_EQ(crest_defects(bed, true, 24.0).lines, 1);
    bed(60, 30) = 2.0;  // seen in three rows of the smoothed bed; a line needs six
    EXPECT_EQ(crest_defects(bed, true, 24.0).lines, 1);
    bed(60, 38) = 2.0;
    bed(60, 34) = 2.0;
    EXPECT_EQ(crest_defects(bed, true, 24.0).lines, 2);
}

TEST(CrestDefects, AtTheEdgeOfAnOpenBedAreNone) {
    // One crest ends in the middle, at y = 60; it leaves over the northern edge.
    const Grid bed = with_pair(96, 120, 8.0, 40.3, 60.4, 400.0);
    EXPECT_EQ(crest_defects(bed, false, 12.0).ends, 1);
}

TEST(CrestDefects, AreUndefinedWithoutAWavelength) {
    const Grid bed = test::waves(40, 20, 4.0);
    for (const double wavelength : {std::nan(""), 2.0, 41.0}) {
        const CrestDefects found = crest_defects(bed, true, wavelength);
        EXPECT_TRUE(std::isnan(found.defect_density));
        EXPECT_TRUE(std::isnan(found.ends_per_square_wavelength));
        EXPECT_EQ(found.lines, 0);
    }
    EXPECT_TRUE(std::isnan(crest_defects(Grid(40, 20, 0.1), true, 10.0).defect_density));
    EXPECT_TRUE(std::isnan(crest_defects(test::waves(40, 1, 4.0), true, 10.0).defect_density));
}

TEST(CrestLines, FollowATurnedCrestRoundTheBed) {
    // One wave over x for each turn over y: a single line that closes after all five.
    const std::vector<CrestLine> lines = crest_lines(test::waves(50, 40, 5.0, 1.0), true, 10.0);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    EXPECT_EQ(lines[0].x.size(), 200U);
    EXPECT_NEAR(lines[0].x.back() - lines[0].x.front(), -199 * 10.0 / 40.0, 0.2);
}

}  // namespace
}  // namespace fumon
