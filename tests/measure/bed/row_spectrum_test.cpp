#include "measure/bed/row_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "base/error.h"
#include "support/measured_beds.h"

namespace fumon {
namespace {

using Complex = std::complex<double>;
using test::turn;

TEST(PowerAlongX, OfOneWaveIsInItsBin) {
    const std::vector<double> power = power_along_x(test::waves(60, 3, 7.0), true);
    ASSERT_EQ(power.size(), 31U);
    EXPECT_NEAR(power[7], 3 * 30.0 * 30.0, 1e-9);  // |n/2|² for each row
    EXPECT_NEAR(power[0], 0.0, 1e-9);
    EXPECT_NEAR(power[8], 0.0, 1e-9);
}

TEST(PowerAlongX, IsThatOfTheRowsOneByOne) {
    const Grid bed = test::noise(21, 5, 1);
    const std::vector<double> power = power_along_x(bed, true);
    std::vector<double> expected(11);
    for (int y = 0; y < bed.ny(); ++y) {
        for (std::size_t k = 1; k < expected.size(); ++k) {
            Complex sum;
            for (int x = 0; x < bed.nx(); ++x) {
                sum += bed(x, y) * std::polar(1.0, -turn * static_cast<double>(k) * x / bed.nx());
            }
            expected[k] += std::norm(sum);
        }
    }
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(power[k], expected[k], 1e-11);
}

/// The definition, summed out.
double plain_autocorrelation(const Grid& bed, int shift) {
    double covariance = 0.0;
    double variance = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        double mean = 0.0;
        for (const double h : bed.row(y)) mean += h / bed.nx();
        for (int x = 0; x < bed.nx(); ++x) {
            covariance += (bed(x, y) - mean) * (bed((x + shift) % bed.nx(), y) - mean);
            variance += (bed(x, y) - mean) * (bed(x, y) - mean);
        }
    }
    return covariance / variance;
}

TEST(Autocorrelation, AgreesWithThePlainSum) {
    const Grid bed = test::noise(30, 3, 5);
    const std::vector<double> found = autocorrelation_along_x(bed, true);
    ASSERT_EQ(found.size(), 30U);
    for (int shift = 0; shift < 30; ++shift) {
        EXPECT_NEAR(found[static_cast<std::size_t>(shift)], plain_autocorrelation(bed, shift),
                    1e-12);
    }
}

TEST(Autocorrelation, OfAnOpenBedCountsTheOverlapOnly) {
    // The departures of 0 1 0 1 … 0 from their mean; its fitted line is level.
    const int nx = 21;
    const Grid bed = test::bed_of(nx, 2, [](int x, int) { return x % 2; });
    const std::vector<double> found = autocorrelation_along_x(bed, false);
    ASSERT_EQ(found.size(), 11U);
    const double mean = 10.0 / 21.0;
    const auto covariance = [&](int shift) {
        double sum = 0.0;
        for (int x = 0; x + shift < nx; ++x) sum += (x % 2 - mean) * ((x + shift) % 2 - mean);
        return sum / (nx - shift);
    };
    for (int shift = 0; shift < 11; ++shift) {
        EXPECT_NEAR(found[static_cast<std::size_t>(shift)], covariance(shift) / covariance(0),
                    1e-12);
    }
}

TEST(Correlations, AreEmptyWithoutRelief) {
    const Grid level(16, 4, 0.1);
    for (const Grid& bed : {Grid(), Grid(0, 3), Grid(1, 3, 2.0)}) {
        EXPECT_TRUE(autocorrelation_along_x(bed, true).empty());
        EXPECT_TRUE(cross_correlation_along_x(bed, bed).empty());
    }
    EXPECT_TRUE(autocorrelation_along_x(level, true).empty());
    EXPECT_TRUE(autocorrelation_along_x(level, false).empty());
    EXPECT_TRUE(cross_correlation_along_x(level, test::noise(16, 4, 1)).empty());
}

TEST(CrossCorrelation, IsOneWhereTheBedHasMovedTo) {
    const Grid bed = test::noise(35, 4, 2);
    const std::vector<double> found = cross_correlation_along_x(bed, test::moved(bed, 9));
    const auto peak = std::max_element(found.begin(), found.end());
    EXPECT_EQ(peak - found.begin(), 9);
    EXPECT_NEAR(*peak, 1.0, 1e-12);
}

TEST(CrossCorrelation, RefusesBedsOfDifferentSize) {
    EXPECT_THROW(cross_correlation_along_x(Grid(8, 4), Grid(8, 5)), Error);
}

}  // namespace
}  // namespace fumon
