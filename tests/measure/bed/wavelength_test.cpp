#include "measure/bed/wavelength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/measured_beds.h"

namespace fumon {
namespace {

using test::turn;

TEST(Wavelength, OfPlainWavesIsFoundByAllThree) {
    const Grid bed = test::waves(120, 7, 10.0, 1.0, 0.3);
    EXPECT_NEAR(wavelength_spectrum(bed, true), 12.0, 1e-9);
    EXPECT_NEAR(wavelength_autocorrelation(bed, true), 12.0, 1e-9);
    EXPECT_NEAR(wavelength_crossings(bed, true), 12.0, 1e-12);
}

TEST(Wavelength, OfWavesThatFillAPrimeNumberOfSites) {
    const Grid profile = test::waves(4099, 1, 41.0);
    EXPECT_NEAR(wavelength_spectrum(profile, true), 4099.0 / 41.0, 1e-6);
    EXPECT_NEAR(wavelength_autocorrelation(profile, true), 4099.0 / 41.0, 0.05);
    EXPECT_NEAR(wavelength_crossings(profile, true), 4099.0 / 41.0, 1e-9);
}

TEST(Wavelength, OfOneWaveInTheBed) {
    const Grid bed = test::waves(64, 2, 1.0);
    EXPECT_NEAR(wavelength_autocorrelation(bed, true), 64.0, 1e-6);
    EXPECT_NEAR(wavelength_crossings(bed, true), 64.0, 1e-12);
}

TEST(Wavelength, SurvivesNoise) {
    const Grid bed = test::sum(test::waves(200, 50, 16.0), test::noise(200, 50, 4), 1.5);
    EXPECT_NEAR(wavelength_spectrum(bed, true), 12.5, 0.2);
    EXPECT_NEAR(wavelength_autocorrelation(bed, true), 12.5, 0.2);
}

TEST(Wavelength, OfAnOpenBedDoesNotSeeItsSlopeOrItsEnds) {
    // 12.6 waves on a slope 40 times as high: neither end nor count fits the bed.
    const Grid bed =
        test::bed_of(252, 3, [](int x, int) { return 0.3 * x + std::sin(turn * x / 20.0 + 1.0); });
    EXPECT_NEAR(wavelength_spectrum(bed, false), 20.0, 0.15);
    EXPECT_NEAR(wavelength_autocorrelation(bed, false), 20.0, 0.15);
    EXPECT_NEAR(wavelength_crossings(bed, false), 20.0, 0.15);
}

TEST(Wavelength, IsUndefinedWithoutRelief) {
    for (const bool periodic : {true, false}) {
        for (const Grid& bed : {Grid(50, 3, 0.1), Grid(3, 50, 1.0), Grid()}) {
            EXPECT_TRUE(std::isnan(wavelength_spectrum(bed, periodic)));
            EXPECT_TRUE(std::isnan(wavelength_autocorrelation(bed, periodic)));
            EXPECT_TRUE(std::isnan(wavelength_crossings(bed, periodic)));
        }
    }
    // Half a wave in an open bed does not come back.
    EXPECT_TRUE(std::isnan(wavelength_crossings(test::waves(50, 1, 0.5), false)));
    EXPECT_TRUE(std::isnan(wavelength_autocorrelation(test::waves(50, 1, 1.0), false)));
}

TEST(WavelengthSpectrum, IsTheCentroidAboutThePeak) {
    // Amplitudes 3, 2, 1 in bins 10, 12, 13: the last lies outside the peak ± 2.
    const Grid bed = test::bed_of(120, 1, [](int x, int) {
        const double phase = turn * x / 120.0;
        return 3.0 * std::sin(10 * phase) + 2.0 * std::sin(12 * phase) + std::sin(13 * phase);
    });
    EXPECT_NEAR(wavelength_spectrum(bed, true), 120.0 * (9.0 + 4.0) / (9.0 * 10 + 4.0 * 12), 1e-9);
}

TEST(WavelengthAutocorrelation, TellsTheDistanceOfCrestsNotTheirModulation) {
    // Every second crest lower: the first peak, at one distance, is lower than the second.
    const Grid bed = test::bed_of(200, 1, [](int x, int) {
        return std::sin(turn * x / 10.0) + 0.5 * std::sin(turn * x / 20.0);
    });
    EXPECT_NEAR(wavelength_autocorrelation(bed, true), 10.0, 0.3);
}

TEST(WavelengthCrossings, PassOverRipplesOnTheFlanks) {
    const Grid bed = test::bed_of(300, 2, [](int x, int) {
        return std::sin(turn * x / 50.0) + 0.2 * std::sin(turn * x / 3.0);
    });
    EXPECT_NEAR(wavelength_crossings(bed, true), 50.0, 1e-12);
}

TEST(WavelengthCrossings, DoNotDependOnWhereTheRowBegins) {
    const Grid bed = test::sum(test::waves(97, 3, 9.0), test::noise(97, 3, 8), 2.0);
    const double expected = wavelength_crossings(bed, true);
    for (int sites = 1; sites < 97; ++sites) {
        EXPECT_DOUBLE_EQ(wavelength_crossings(test::moved(bed, sites), true), expected) << sites;
    }
}

}  // namespace
}  // namespace fumon
