#include "measure/pile/power_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;

/// Independent draws from p(s) ∝ weight(s) on the window, by searching its cumulative sums.
template <class Weight>
AvalancheSizes draw(SizeWindow window, int avalanches, std::uint32_t sample, Weight weight) {
    std::vector<double> sums;
    double sum = 0.0;
    for (std::int64_t size = window.low; size <= window.high; ++size)
        sums.push_back(sum += weight(static_cast<double>(size)));
    RandomStream stream(7, sample, 0, Purpose::picks);
    AvalancheSizes sizes;
    for (int i = 0; i < avalanches; ++i) {
        const auto at = std::upper_bound(sums.begin(), sums.end(), stream.uniform() * sum);
        sizes.add(window.low + (at - sums.begin()));
    }
    return sizes;
}

AvalancheSizes draw_power_law(SizeWindow window, double exponent, int avalanches,
                              std::uint32_t sample) {
    return draw(window, avalanches, sample, [&](double s) { return std::pow(s, -exponent); });
}

AvalancheSizes draw_exponential(SizeWindow window, double mean, int avalanches,
                                std::uint32_t sample) {
    return draw(window, avalanches, sample, [&](double s) { return std::exp(-s / mean); });
}

struct Law {
    double exponent;
    SizeWindow window;
};

class KnownLaw : public ::testing::TestWithParam<Law> {};

TEST_P(KnownLaw, IsRecoveredByLikelihoodWithATrueStandardError) {
    const auto [exponent, window] = GetParam();
    constexpr int samples = 200;
    int beyond_three = 0;  // standard errors
    double mean = 0.0;
    double squares = 0.0;
    double error = 0.0;
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
        const LikelihoodFit fit =
            fit_likelihood(draw_power_law(window, exponent, 2000, sample), window);
        if (std::abs(fit.exponent - exponent) > 3.0 * fit.standard_error) ++beyond_three;
        EXPECT_EQ(fit.avalanches, 2000);
        mean += fit.exponent / samples;
        squares += (fit.exponent - exponent) * (fit.exponent - exponent) / samples;
        error += fit.standard_error / samples;
    }
    EXPECT_LE(beyond_three, 3);  // 0.5 are expected
    EXPECT_NEAR(mean, exponent, 3.0 * error / std::sqrt(samples));
    EXPECT_NEAR(std::sqrt(squares) / error, 1.0, 3.0 / std::sqrt(2.0 * samples));
}

TEST_P(KnownLaw, IsNotDoubted) {
    const auto [exponent, window] = GetParam();
    int doubted = 0;
    constexpr int samples = 20;
    for (std::uint32_t sample = 0; sample < samples; ++sample) {
        const auto sizes = draw_power_law(window, exponent, 2000, sample);
        if (power_law_probability(sizes, window, 50) < 0.1) ++doubted;
    }
    EXPECT_LE(doubted, 6);  // 2 are expected; more than 6 come once in 400
}

INSTANTIATE_TEST_SUITE_P(Laws, KnownLaw,
                         ::testing::Values(Law{1.5, {10, 100}}, Law{2.0, {10, 100}},
                                           Law{2.5, {10, 100}}, Law{1.5, {1, 1000}},
                                           Law{2.0, {1, 1000}}, Law{2.5, {1, 1000}}),
                         [](const auto& law) {
                             return "Exponent" +
                                    std::to_string(std::lround(law.param.exponent * 10)) +
                                    "Tenths" + std::to_string(law.param.window.low) + "To" +
                                    std::to_string(law.param.window.high);
                         });

TEST(PowerLawProbability, IsEvenlySpreadWhereTheLawHolds) {
    double mean = 0.0;
    constexpr int samples = 100;
    for (std::uint32_t sample = 0; sample < samples; ++sample)
        mean += power_law_probability(draw_power_law({10, 100}, 1.6, 1000, sample), {10, 100}, 50) /
                samples;
    EXPECT_NEAR(mean, 0.5, 3.0 / std::sqrt(12.0 * samples));
}

TEST(PowerLawProbability, DoubtsAnExponentialSample) {
    const auto sizes = draw_exponential({10, 100}, 20.0, 2000, 0);
    EXPECT_GT(fit_raw_bins(sizes, {10, 100}).r_squared, 0.8);  // which its straight line does not
    EXPECT_LT(power_law_probability(sizes, {10, 100}), 0.01);
    EXPECT_LT(power_law_probability(draw_exponential({1, 1000}, 50.0, 2000, 1), {1, 1000}), 0.01);
}

TEST(PowerLawProbability, IsTheSameEveryTime) {
    const auto sizes = draw_power_law({10, 100}, 1.6, 500, 3);
    const double once = power_law_probability(sizes, {10, 100});
    EXPECT_EQ(power_law_probability(sizes, {10, 100}), once);
    EXPECT_GT(once, 0.0);
}

/// Counts that are 10^12 · s^−2, rounded: as good as exact.
AvalancheSizes exact_shares(std::int64_t low, std::int64_t high) {
    AvalancheSizes sizes;
    for (std::int64_t s = low; s <= high; ++s)
        sizes.add(s, std::llround(1e12 / static_cast<double>(s * s)));
    return sizes;
}

TEST(RawBins, ExactSharesGiveTheExactLine) {
    const auto sizes = exact_shares(1, 1000);
    const LineFit fit = fit_raw_bins(sizes, {10, 100});
    EXPECT_NEAR(fit.slope, -2.0, 1e-8);
    EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
    EXPECT_NEAR(fit.standard_error, 0.0, 1e-8);
    EXPECT_EQ(fit.points, 91);
    const double total = static_cast<double>(sizes.avalanches());
    EXPECT_NEAR(fit.intercept, std::log10(1e12 / total), 1e-8);  // the share of size 1
}

TEST(RawBins, TheLineIsThatOfLeastSquares) {
    AvalancheSizes sizes;  // log10 of size 0, 1, 2 and of count 2, 2, 0: slope −1, means 1 and 4/3
    sizes.add(1, 100);
    sizes.add(10, 100);
    sizes.add(100, 1);
    const LineFit fit = fit_raw_bins(sizes, {1, 100});
    EXPECT_NEAR(fit.slope, -1.0, 1e-14);
    EXPECT_NEAR(fit.intercept, 7.0 / 3.0 - std::log10(201.0), 1e-14);
    EXPECT_NEAR(fit.r_squared, 0.75, 1e-14);
    EXPECT_NEAR(fit.standard_error, std::sqrt(1.0 / 3.0), 1e-14);
    EXPECT_EQ(fit.points, 3);
}

TEST(RawBins, AreTooShallowWhereCountsAreSmall) {
    const auto sizes = draw_power_law({1, 1000}, 2.0, 2000, 0);
    EXPECT_GT(fit_raw_bins(sizes, {1, 1000}).slope, -1.6);
    EXPECT_NEAR(fit_logarithmic_bins(sizes, {1, 1000}).slope, -2.0, 0.2);
}

TEST(LineFits, SeeTheWindowOnly) {
    AvalancheSizes sizes = exact_shares(10, 100);
    const double slope = fit_raw_bins(sizes, {10, 100}).slope;
    const double binned = fit_logarithmic_bins(sizes, {10, 99}).slope;
    const LikelihoodFit likely = fit_likelihood(sizes, {10, 100});
    sizes.add(9, 1);
    sizes.add(101, 77);
    EXPECT_NEAR(fit_raw_bins(sizes, {10, 100}).slope, slope, 1e-12);
    EXPECT_NEAR(fit_logarithmic_bins(sizes, {10, 99}).slope, binned, 1e-12);
    EXPECT_EQ(fit_likelihood(sizes, {10, 100}).exponent, likely.exponent);
    EXPECT_EQ(fit_likelihood(sizes, {10, 100}).avalanches, likely.avalanches);
}

TEST(LogarithmicBinFit, ExactSharesGiveTheSlope) {
    const LineFit fit = fit_logarithmic_bins(exact_shares(1, 10'000), {10, 1000});
    EXPECT_NEAR(fit.slope, -2.0, 0.005);  // bins hold whole numbers: their middles are off a little
    EXPECT_GT(fit.r_squared, 0.9999);
    EXPECT_EQ(fit.points, 16);
}

TEST(LogarithmicBinFit, TakesWholeBinsOnly) {
    const auto sizes = exact_shares(1, 1000);
    EXPECT_EQ(fit_logarithmic_bins(sizes, {10, 99}, 8).points, 8);
    EXPECT_EQ(fit_logarithmic_bins(sizes, {11, 98}, 8).points, 6);
    EXPECT_EQ(fit_logarithmic_bins(sizes, {11, 98}, 1).points, 0);
}

TEST(Likelihood, ExactSharesGiveTheExponent) {
    const LikelihoodFit fit = fit_likelihood(exact_shares(10, 100), {10, 100});
    EXPECT_NEAR(fit.exponent, 2.0, 1e-8);
    EXPECT_NEAR(fit.distance, 0.0, 1e-9);
}

TEST(Likelihood, OfTwoSizesIsTheirRatio) {
    AvalancheSizes sizes;
    sizes.add(1, 800);
    sizes.add(2, 100);
    const LikelihoodFit fit = fit_likelihood(sizes, {1, 2});
    EXPECT_NEAR(fit.exponent, 3.0, 1e-11);  // 2^3 = 800 / 100
    // Var ln s = p (1 − p) ln² 2, p = 8/9, n = 900
    EXPECT_NEAR(fit.standard_error, 1.0 / (std::sqrt(900.0 * 8.0 / 81.0) * std::log(2.0)), 1e-11);
    EXPECT_NEAR(fit.distance, 0.0, 1e-12);
}

TEST(Likelihood, GrowingSharesHaveANegativeExponent) {
    AvalancheSizes sizes;
    for (std::int64_t s = 10; s <= 100; ++s) sizes.add(s, s * s * s);
    EXPECT_NEAR(fit_likelihood(sizes, {10, 100}).exponent, -3.0, 1e-9);
}

TEST(Likelihood, TheDistanceIsTheLargestGapOfCumulativeShares) {
    AvalancheSizes sizes;
    sizes.add(1, 500);
    sizes.add(3, 500);
    // p ∝ 1, 2^−a, 3^−a with E[ln s] = ln 3 / 2; at the exponent found the gap is largest at 1 or 2
    const LikelihoodFit fit = fit_likelihood(sizes, {1, 3});
    const double two = std::pow(2.0, -fit.exponent);
    const double three = std::pow(3.0, -fit.exponent);
    const double total = 1.0 + two + three;
    EXPECT_NEAR((two * std::log(2.0) + three * std::log(3.0)) / total, 0.5 * std::log(3.0), 1e-12);
    EXPECT_NEAR(fit.distance, std::max(0.5 - 1.0 / total, (1.0 + two) / total - 0.5), 1e-12);
}

void expect_no_fit(const AvalancheSizes& sizes, std::int64_t points) {
    const LineFit raw = fit_raw_bins(sizes, {10, 100});
    EXPECT_TRUE(std::isnan(raw.slope));
    EXPECT_TRUE(std::isnan(raw.r_squared));
    EXPECT_EQ(raw.points, points);
    EXPECT_TRUE(std::isnan(fit_logarithmic_bins(sizes, {10, 100}).slope));
    EXPECT_TRUE(std::isnan(fit_likelihood(sizes, {10, 100}).exponent));
    EXPECT_TRUE(std::isnan(fit_likelihood(sizes, {10, 100}).standard_error));
    EXPECT_TRUE(std::isnan(fit_likelihood(sizes, {10, 100}).distance));
    EXPECT_TRUE(std::isnan(power_law_probability(sizes, {10, 100})));
}

TEST(PowerLaw, IsNotFittedWithoutAvalanchesInTheWindow) {
    expect_no_fit({}, 0);
    AvalancheSizes outside;
    outside.add(9, 100);
    outside.add(101, 3);
    expect_no_fit(outside, 0);
}

TEST(PowerLaw, IsNotFittedToOneSize) {
    for (const std::int64_t size : {10, 30, 100}) {
        AvalancheSizes one;
        one.add(size, 50);
        expect_no_fit(one, 1);
    }
}

TEST(PowerLaw, BeyondAnySensibleExponentIsNone) {
    AvalancheSizes sizes;
    sizes.add(1000, 1'000'000);
    sizes.add(1001, 1);
    EXPECT_TRUE(std::isnan(fit_likelihood(sizes, {1000, 2000}).exponent));
}

TEST(PowerLaw, RefusesAWindowThatIsNone) {
    const AvalancheSizes none;
    const std::string remedy = "; the window starts at 1 or above and ends above its start";
    EXPECT_EQ(message_of<InputError>([&] {
                  fit_raw_bins(none, {100, 10});
              }),
              "a power law cannot be fitted to avalanche sizes 100 to 10" + remedy);
    EXPECT_EQ(message_of<InputError>([&] {
                  fit_logarithmic_bins(none, {10, 10});
              }),
              "a power law cannot be fitted to avalanche sizes 10 to 10" + remedy);
    EXPECT_EQ(message_of<InputError>([&] {
                  fit_likelihood(none, {0, 10});
              }),
              "a power law cannot be fitted to avalanche sizes 0 to 10" + remedy);
    EXPECT_EQ(message_of<InputError>([&] {
                  power_law_probability(none, {1, 4'194'305});
              }),
              "a power law cannot be fitted to avalanche sizes 1 to 4194305; a window holds at "
              "most 4194304 sizes");
    EXPECT_EQ(message_of<Error>([&] {
                  power_law_probability(none, {1, 10}, 0);
              }),
              "0 resamples; at least 1 is needed");
}

TEST(BestWindow, StartsWhereThePowerLawDoes) {
    AvalancheSizes sizes = draw_power_law({20, 1000}, 1.8, 20'000, 0);
    for (std::int64_t s = 1; s < 20; ++s)
        sizes.add(s, 800);  // even below 20; the law has 1200 at 20
    const SizeWindow window = best_window(sizes, 1000);
    EXPECT_GE(window.low, 19);
    EXPECT_LE(window.low, 30);
    EXPECT_EQ(window.high, 1000);
    EXPECT_NEAR(fit_likelihood(sizes, window).exponent, 1.8, 0.06);
}

TEST(BestWindow, IsRefusedWhereNothingIsLeftToFit) {
    AvalancheSizes sizes;
    sizes.add(5, 60);
    sizes.add(6, 39);
    EXPECT_EQ(
        message_of<InputError>([&] { best_window(sizes, 100); }),
        "no window of avalanche sizes up to 100 spans a decade and holds 100 avalanches; take "
        "more grains or a larger end");
    sizes.add(6);
    EXPECT_EQ(best_window(sizes, 100).low, 5);
}

}  // namespace
}  // namespace fumon
