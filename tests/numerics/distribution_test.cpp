#include "numerics/distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fumon {
namespace {

const std::vector<double> ten{3.0, 1.0, 4.0, 1.5, 9.0, 2.6, 5.3, 5.8, -7.0, 25.0};

TEST(DistributionTest, QuartilesAreNumpys) {
    const BoxStatistics box = box_statistics(ten);
    EXPECT_EQ(box.count, 10);
    EXPECT_NEAR(box.lower_quartile, 1.775, 1e-14);  // numpy.percentile(ten, [25, 50, 75])
    EXPECT_NEAR(box.median, 3.5, 1e-14);
    EXPECT_NEAR(box.upper_quartile, 5.675, 1e-14);
    EXPECT_NEAR(box.mean, 5.02, 1e-14);
    // Within 1.775 − 1.5 × 3.9 = −4.075 and 5.675 + 5.85 = 11.525.
    EXPECT_EQ(box.lower_whisker, 1.0);
    EXPECT_EQ(box.upper_whisker, 9.0);
    EXPECT_EQ(box.beyond, (std::vector<double>{-7.0, 25.0}));
    const BoxStatistics one = box_statistics({2.0});
    EXPECT_EQ(one.lower_quartile, 2.0);
    EXPECT_EQ(one.upper_whisker, 2.0);
    EXPECT_TRUE(one.beyond.empty());
}

TEST(DistributionTest, BinsAreNumpys) {
    // numpy.histogram(ten, bins="auto")
    const std::vector<double> edges = bin_edges(ten, {0, -7.0, 25.0});
    ASSERT_EQ(edges.size(), 10U);
    EXPECT_NEAR(edges[1], -3.44444444, 1e-8);
    EXPECT_EQ(edges.back(), 25.0);
    EXPECT_EQ(bin_counts(ten, edges), (std::vector<std::int64_t>{1, 0, 4, 3, 1, 0, 0, 0, 1}));
    // bins=4: 1, at the first bin's end, counts in the second, and 9 in the third.
    EXPECT_EQ(bin_counts(ten, bin_edges(ten, {4, -7.0, 25.0})),
              (std::vector<std::int64_t>{1, 7, 1, 1}));
    // bins=5, range=(0, 10): what lies outside is not counted
    EXPECT_EQ(bin_counts(ten, bin_edges(ten, {5, 0.0, 10.0})),
              (std::vector<std::int64_t>{2, 2, 3, 0, 1}));
    // Quartiles without a range: Sturges's rule alone.
    const std::vector<double> flat{1, 1, 1, 1, 1, 1, 1, 1, 2, 9};
    EXPECT_EQ(bin_counts(flat, bin_edges(flat, {0, 1.0, 9.0})),
              (std::vector<std::int64_t>{9, 0, 0, 0, 1}));
    std::vector<double> many;
    for (int i = 0; i < 40; ++i) many.push_back(i * std::sqrt(i) / 7.0);
    EXPECT_EQ(bin_counts(many, bin_edges(many, {0, many.front(), many.back()})),
              (std::vector<std::int64_t>{11, 6, 6, 4, 5, 4, 4}));
    EXPECT_EQ(bin_edges(std::vector<double>{3.0}, {0, 3.0, 3.0}), (std::vector<double>{2.5, 3.5}));
}

TEST(DistributionTest, LogarithmicBinsAreEvenInTheLogarithms) {
    const std::vector<double> edges = bin_edges(ten, {3, 1.0, 1000.0, true});
    ASSERT_EQ(edges.size(), 4U);
    EXPECT_NEAR(edges[1], 10.0, 1e-12);
    EXPECT_NEAR(edges[2], 100.0, 1e-11);
}

TEST(DistributionTest, DensitiesAreThoseOfScottsRule) {
    const DensityCurve curve = gaussian_density(ten);  // scipy.stats.gaussian_kde(ten)
    ASSERT_EQ(curve.value.size(), 100U);
    EXPECT_EQ(curve.value.front(), -7.0);
    EXPECT_EQ(curve.value.back(), 25.0);
    EXPECT_NEAR(curve.density[0], 0.016242930486298483, 1e-15);
    EXPECT_NEAR(curve.density[33], 0.05676970622510394, 1e-15);
    EXPECT_NEAR(curve.density[99], 0.007824040029651374, 1e-15);
    EXPECT_TRUE(gaussian_density(std::vector<double>{2.0, 2.0}).value.empty());
}

}  // namespace
}  // namespace fumon
