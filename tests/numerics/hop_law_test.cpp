#include "numerics/hop_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/error.h"
#include "base/random.h"

namespace fumon::test {
namespace {

std::vector<HopPoint> points_of(const std::function<double(double height, double slope)>& length) {
    RandomStream stream(7, 0, 0, Purpose::initial_bed);
    std::vector<HopPoint> points;
    for (int n = 0; n < 500; ++n) {
        const double height = 0.5 * stream.uniform();
        const double slope = 2.0 * stream.uniform() - 1.0;
        points.push_back({height, slope, length(height, slope)});
    }
    return points;
}

TEST(HopLaw, FindsTheExponential) {
    for (const double base : {1.5, 5.4, 80.0}) {
        const auto points = points_of([&](double h, double) { return std::pow(base, h) - 1.0; });
        const ExponentialLaw law = fit_exponential(points);
        EXPECT_NEAR(law.base / base, 1.0, 1e-9);
        EXPECT_NEAR(law.r_squared, 1.0, 1e-12);
        EXPECT_NEAR(law.length(0.5), std::sqrt(base) - 1.0, 1e-9);
        EXPECT_LT(fit_linear(points).r_squared, 0.9999);
    }
}

TEST(HopLaw, TheExponentialIsTheBestOfAllBases) {
    const auto points = points_of([](double h, double s) { return 2.0 * h + 0.3 * s - 0.05; });
    const ExponentialLaw law = fit_exponential(points);
    const auto misfit = [&](double base) {
        double sum = 0.0;
        for (const HopPoint& point : points)
            sum += std::pow(point.length - (std::pow(base, point.height) - 1.0), 2.0);
        return sum;
    };
    for (double base = 1.01; base < 50.0; base *= 1.01)
        EXPECT_LE(misfit(law.base), misfit(base) * (1.0 + 1e-12)) << base;
}

TEST(HopLaw, FindsTheLineAndItsScatter) {
    const auto points = points_of([](double h, double) { return 0.4 + 3.0 * h; });
    const LinearLaw law = fit_linear(points);
    EXPECT_NEAR(law.constant, 0.4, 1e-12);
    EXPECT_NEAR(law.per_height, 3.0, 1e-12);
    EXPECT_NEAR(law.r_squared, 1.0, 1e-12);
    // variances 9/48 of 3h over [0, 1/2) and 1/3 · 0.75² of the slope's part: half and half
    const auto scattered = points_of([](double h, double s) { return 3.0 * h + 0.75 * s; });
    EXPECT_NEAR(fit_linear(scattered).r_squared, 0.5, 0.05);
}

TEST(HopLaw, FindsTheDuneRule) {
    const auto points = points_of([](double, double s) { return 5.0 - 4.0 * std::tanh(s); });
    const SlopeLaw law = fit_slope(points);
    EXPECT_NEAR(law.constant, 5.0, 1e-12);
    EXPECT_NEAR(law.factor, 4.0, 1e-12);
    EXPECT_NEAR(law.r_squared, 1.0, 1e-12);
}

TEST(HopLaw, TabulatesMeansOverBins) {
    const std::vector<HopPoint> points{
        {0.0, 0.0, 1.0}, {0.1, 0.0, 2.0}, {0.9, 0.0, 7.0}, {1.0, 0.0, 9.0}};
    const HopTable table = tabulate(points, 4);
    ASSERT_EQ(table.heights.size(), 2U) << "the two bins in the middle are empty";
    EXPECT_NEAR(table.heights[0], 0.05, 1e-12);
    EXPECT_NEAR(table.heights[1], 0.95, 1e-12);
    EXPECT_EQ(table.lengths, (std::vector<double>{1.5, 8.0}));
    EXPECT_EQ(table.counts, (std::vector<int>{2, 2}));
}

TEST(HopLaw, RefusesTooFewPointsAndAFlatBed) {
    const std::vector<HopPoint> flat{{0.5, 0.0, 1.0}, {0.5, 0.0, 2.0}, {0.5, 0.0, 3.0}};
    EXPECT_THROW(static_cast<void>(fit_exponential(flat)), Error);
    EXPECT_THROW(static_cast<void>(fit_linear(flat)), Error);
    EXPECT_THROW(static_cast<void>(fit_slope(flat)), Error);
    EXPECT_THROW(static_cast<void>(tabulate(flat, 4)), Error);
    EXPECT_THROW(static_cast<void>(fit_linear(std::span(flat).first(2))), Error);
}

}  // namespace
}  // namespace fumon::test
