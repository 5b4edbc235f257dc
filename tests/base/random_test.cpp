#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace fumon {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The known answers that accompany Random123 (Salmon, Moraes, Dror & Shaw 2011) for philox4x32-10.
TEST(Philox, GivesThePublishedKnownAnswers) {
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
              (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(
        philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
        (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(
        philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
        (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, FillGivesTheSameWordsAsOneByOne) {
    for (const std::size_t count : {0U, 1U, 3U, 63U, 64U, 65U, 67U, 71U, 1000U}) {
        RandomStream one(0x123456789abcdefULL, 7, 9, Purpose::picks);
        RandomStream many(0x123456789abcdefULL, 7, 9, Purpose::picks);
        one.next32();  // start inside a block
        many.next32();
        std::vector<std::uint32_t> words(count);
        many.fill(words);
        for (const std::uint32_t word : words) ASSERT_EQ(word, one.next32());
        EXPECT_EQ(many.next32(), one.next32());
    }
}

TEST(RandomStream, EveryCoordinateMakesAnotherStream) {
    std::set<std::uint64_t> firsts;
    firsts.insert(RandomStream(1, 0, 0, Purpose::picks).next64());
    firsts.insert(RandomStream(2, 0, 0, Purpose::picks).next64());
    firsts.insert(RandomStream(1ULL << 32, 0, 0, Purpose::picks).next64());
    firsts.insert(RandomStream(1, 1, 0, Purpose::picks).next64());
    firsts.insert(RandomStream(1, 0, 1, Purpose::picks).next64());
    firsts.insert(RandomStream(1, 0, 0, Purpose::initial_bed).next64());
    EXPECT_EQ(firsts.size(), 6U);
}

/// Chi-square of counts against equal expectation, as a number of standard deviations above its
/// mean.
double chi_square_excess(const std::vector<double>& counts, const std::vector<double>& expected) {
    double chi_square = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        chi_square += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    }
    const auto freedom = static_cast<double>(counts.size() - 1);
    return (chi_square - freedom) / std::sqrt(2.0 * freedom);
}

TEST(RandomStream, BelowIsUniform) {
    RandomStream stream(3, 0, 0, Purpose::picks);
    constexpr std::uint32_t sides = 97;
    constexpr int draws = 970000;
    std::vector<double> counts(sides, 0.0);
    for (int i = 0; i < draws; ++i) counts[stream.below(sides)] += 1.0;
    EXPECT_LT(std::fabs(chi_square_excess(counts, std::vector<double>(sides, draws / 97.0))), 4.0);
}

TEST(RandomStream, BelowHasNoModuloBias) {
    // With a count of 3·2^30 a plain modulo or a plain multiply would favour a third of the values
    // by 2 to 1.
    RandomStream stream(4, 0, 0, Purpose::picks);
    constexpr std::uint32_t count = 3U << 30U;
    std::vector<double> residues(3, 0.0);
    for (int i = 0; i < 300000; ++i) residues[stream.below(count) % 3U] += 1.0;
    EXPECT_LT(std::fabs(chi_square_excess(residues, std::vector<double>(3, 100000.0))), 4.0);
}

TEST(RandomStream, UniformHasTheRightMoments) {
    RandomStream stream(5, 0, 0, Purpose::initial_bed);
    constexpr int draws = 1000000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < draws; ++i) {
        const double u = stream.uniform();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        squares += u * u;
    }
    EXPECT_NEAR(sum / draws, 0.5, 5 * 0.2887 / 1000);
    EXPECT_NEAR(squares / draws, 1.0 / 3.0, 5 * 0.2981 / 1000);
}

/// The exact binomial distribution, by its logarithms.
double binomial_share(int n, int k, double p) {
    return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                    k * std::log(p) + (n - k) * std::log(1.0 - p));
}

TEST(Binomial, FollowsTheExactDistribution) {
    struct Case {
        int trials;
        double probability;
    };
    for (const Case& one :
         {Case{20, 0.1}, Case{1000, 0.001}, Case{60, 0.4}, Case{400, 0.5}, Case{100, 0.93}}) {
        RandomStream stream(6, 0, one.trials, Purpose::picks_per_row);
        constexpr int draws = 400000;
        std::vector<double> seen(static_cast<std::size_t>(one.trials) + 1, 0.0);
        for (int i = 0; i < draws; ++i) {
            const std::int64_t k = binomial(stream, one.trials, one.probability);
            ASSERT_GE(k, 0);
            ASSERT_LE(k, one.trials);
            seen[static_cast<std::size_t>(k)] += 1.0;
        }
        std::vector<double> counts{0.0};  // cells with few expected are put together in the first
        std::vector<double> expected{0.0};
        for (int k = 0; k <= one.trials; ++k) {
            const double share = draws * binomial_share(one.trials, k, one.probability);
            if (share < 20.0) {
                counts[0] += seen[static_cast<std::size_t>(k)];
                expected[0] += share;
            } else {
                counts.push_back(seen[static_cast<std::size_t>(k)]);
                expected.push_back(share);
            }
        }
        EXPECT_LT(std::fabs(chi_square_excess(counts, expected)), 4.5)
            << one.trials << " trials at " << one.probability;
    }
}

TEST(Multinomial, SharesAllTrialsEvenly) {
    constexpr std::size_t rows = 50;
    std::vector<double> totals(rows, 0.0);
    double squares = 0.0;
    constexpr int rounds = 2000;
    constexpr std::int64_t trials = 5000;
    for (int round = 0; round < rounds; ++round) {
        RandomStream stream(7, 0, round, Purpose::picks_per_row);
        std::vector<std::int64_t> counts(rows);
        multinomial_equal(stream, trials, counts);
        std::int64_t sum = 0;
        for (std::size_t row = 0; row < rows; ++row) {
            sum += counts[row];
            totals[row] += static_cast<double>(counts[row]);
            squares += (static_cast<double>(counts[row]) - 100.0) *
                       (static_cast<double>(counts[row]) - 100.0);
        }
        ASSERT_EQ(sum, trials);
    }
    EXPECT_LT(std::fabs(chi_square_excess(totals, std::vector<double>(rows, 100.0 * rounds))), 4.0);
    EXPECT_NEAR(squares / (rounds * static_cast<double>(rows)), 98.0, 2.0)
        << "variance n p (1 − p)";
}

}  // namespace
}  // namespace fumon
