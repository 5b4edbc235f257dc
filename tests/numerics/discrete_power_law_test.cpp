#include "numerics/discrete_power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace fumon {
namespace {

TEST(DiscretePowerLaw, CumulatesItsShares) {
    const auto cumulative = DiscretePowerLaw({2, 4}).cumulative(2.0);  // 1/4, 1/9, 1/16
    const double sum = 1.0 / 4.0 + 1.0 / 9.0 + 1.0 / 16.0;
    ASSERT_EQ(cumulative.size(), 3U);
    EXPECT_NEAR(cumulative[0], 0.25 / sum, 1e-14);
    EXPECT_NEAR(cumulative[1], (0.25 + 1.0 / 9.0) / sum, 1e-14);
    EXPECT_EQ(cumulative[2], 1.0);
    const auto growing = DiscretePowerLaw({1, 4}).cumulative(-1.0);  // 1, 2, 3, 4
    EXPECT_NEAR(growing[2], 0.6, 1e-14);
}

TEST(DiscretePowerLaw, DrawsEverySizeAsOftenAsItShould) {
    constexpr std::int64_t sample = 2'000'000;
    const DiscretePowerLaw law({10, 100});
    const auto cumulative = law.cumulative(1.6);
    std::vector<std::int64_t> counts(law.sizes());
    RandomStream stream(1, 0, 0, Purpose::bootstrap);
    DiscretePowerLaw::draw(stream, sample, cumulative, counts);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), sample);
    double chi_squared = 0.0;
    for (std::size_t at = 0; at < counts.size(); ++at) {
        const double expected =
            static_cast<double>(sample) * (cumulative[at] - (at == 0 ? 0.0 : cumulative[at - 1]));
        const double off = static_cast<double>(counts[at]) - expected;
        chi_squared += off * off / expected;
    }
    const double freedom = static_cast<double>(counts.size()) - 1.0;
    EXPECT_NEAR(chi_squared, freedom, 3.5 * std::sqrt(2.0 * freedom));
}

TEST(DiscretePowerLaw, SmallSamplesScatterAsTheyShould) {
    const DiscretePowerLaw law({1, 1000});
    const auto cumulative = law.cumulative(1.5);
    std::vector<std::int64_t> counts(law.sizes());
    constexpr int samples = 4000;
    constexpr int sample = 20;
    double ones = 0.0;
    double squares = 0.0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        RandomStream stream(1, i, 0, Purpose::bootstrap);
        DiscretePowerLaw::draw(stream, sample, cumulative, counts);
        ASSERT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), sample);
        ones += static_cast<double>(counts[0]);
        squares += static_cast<double>(counts[0] * counts[0]);
    }
    const double mean = sample * cumulative[0];
    const double variance = mean * (1.0 - cumulative[0]);
    EXPECT_NEAR(ones / samples, mean, 3.5 * std::sqrt(variance / samples));
    const double found = squares / samples - (ones / samples) * (ones / samples);
    EXPECT_NEAR(found / variance, 1.0, 3.5 * std::sqrt(2.0 / samples));
}

TEST(DiscretePowerLaw, TheFirstGuessDoesNotMatter) {
    const DiscretePowerLaw law({1, 100});
    std::vector<std::int64_t> counts(law.sizes());
    counts[0] = 60;
    counts[4] = 11;
    counts[50] = 3;
    const double exponent = law.most_likely(counts).exponent;
    for (const double start : {-60.0, 0.0, 1.0, 8.0, 63.0, 1000.0})
        EXPECT_NEAR(law.most_likely(counts, start).exponent, exponent, 1e-10) << start;
}

TEST(LargestDistance, IsTheLargestGap) {
    const std::vector<double> cumulative{0.5, 0.75, 1.0};
    EXPECT_DOUBLE_EQ(largest_distance(std::vector<std::int64_t>{2, 4, 4}, cumulative), 0.3);
    EXPECT_DOUBLE_EQ(largest_distance(std::vector<std::int64_t>{8, 2, 0}, cumulative), 0.3);
    EXPECT_TRUE(std::isnan(largest_distance(std::vector<std::int64_t>{0, 0, 0}, cumulative)));
}

}  // namespace
}  // namespace fumon
