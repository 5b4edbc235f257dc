#include "measure/pile/avalanche_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

TEST(AvalancheSizes, SharesDivideByTheNumberOfAvalanches) {
    AvalancheSizes sizes;
    const std::vector<Avalanche> avalanches{{1, 4}, {3, 4}, {4, 4}, {7, 9}, {8, 30}};
    sizes.add(avalanches);
    EXPECT_EQ(sizes.avalanches(), 5);
    EXPECT_EQ(sizes.largest(), 30);
    const auto bins = sizes.bins();
    ASSERT_EQ(bins.size(), 3U);
    EXPECT_EQ(bins[0].size, 4);
    EXPECT_EQ(bins[0].count, 3);
    EXPECT_DOUBLE_EQ(bins[0].share, 0.6);
    EXPECT_EQ(bins[1].size, 9);
    EXPECT_DOUBLE_EQ(bins[1].share, 0.2);
    EXPECT_EQ(bins[2].size, 30);
}

TEST(AvalancheSizes, AddUp) {
    AvalancheSizes one;
    one.add(4, 2);
    one.add(6);
    AvalancheSizes other;
    other.add(6, 3);
    other.add(100, 0);
    one.add(other);
    EXPECT_EQ(one.avalanches(), 6);
    ASSERT_EQ(one.bins().size(), 2U);
    EXPECT_EQ(one.bins()[1].count, 4);
    one.add(one);
    EXPECT_EQ(one.avalanches(), 12);
    EXPECT_EQ(one.bins()[1].count, 8);
}

TEST(AvalancheSizes, WithoutAnyHasNoBins) {
    const AvalancheSizes none;
    EXPECT_EQ(none.avalanches(), 0);
    EXPECT_EQ(none.largest(), 0);
    EXPECT_TRUE(none.bins().empty());
    EXPECT_TRUE(none.logarithmic_bins().empty());
}

TEST(AvalancheSizes, RefusesWhatIsNoAvalanche) {
    using test::message_of;
    AvalancheSizes sizes;
    EXPECT_EQ(message_of<Error>([&] { sizes.add(0); }),
              "an avalanche has from 1 to 1000000000000000 cells, not 0");
    EXPECT_EQ(message_of<Error>([&] { sizes.add(1'000'000'000'000'001); }),
              "an avalanche has from 1 to 1000000000000000 cells, not 1000000000000001");
    EXPECT_EQ(message_of<Error>([&] { sizes.add(3, -1); }), "-1 avalanches cannot be counted");
    EXPECT_EQ(message_of<Error>([&] { static_cast<void>(sizes.logarithmic_bins(0)); }),
              "0 bins a decade; from 1 to 100 are possible");
    EXPECT_EQ(sizes.avalanches(), 0);
}

TEST(LogarithmicBins, StandAtEqualRatios) {
    AvalancheSizes sizes;
    sizes.add(1);
    sizes.add(2000);
    const auto bins = sizes.logarithmic_bins(4);  // 1, 1.78, 3.16, 5.62, 10, 17.8, 31.6, 56.2, 100
    ASSERT_GE(bins.size(), 9U);
    const std::vector<std::pair<std::int64_t, std::int64_t>> expected{
        {1, 1}, {2, 3}, {4, 5}, {6, 9}, {10, 17}, {18, 31}, {32, 56}, {57, 99}, {100, 177}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(bins[i].low, expected[i].first) << i;
        EXPECT_EQ(bins[i].high, expected[i].second) << i;
    }
    EXPECT_EQ(bins.back().low, 1779);
    EXPECT_EQ(bins.back().high, 3162);
}

TEST(LogarithmicBins, LeaveOutThoseThatHoldNoSize) {
    AvalancheSizes sizes;
    for (int size = 1; size <= 12; ++size) sizes.add(size);
    const auto bins = sizes.logarithmic_bins(10);  // 1, 1.26, 1.58, 2, 2.5, 3.2, 4, 5, 6.3, 7.9, 10
    ASSERT_EQ(bins.size(), 8U);
    std::int64_t next = 1;
    for (const auto& bin : bins) {
        EXPECT_EQ(bin.low, next);
        EXPECT_EQ(bin.count, bin.high - bin.low + 1);
        next = bin.high + 1;
    }
    EXPECT_EQ(bins[1].high, 2);
    EXPECT_EQ(bins[4].low, 6);
    EXPECT_EQ(bins[4].high, 6);
    EXPECT_EQ(bins[6].high, 9);
}

TEST(LogarithmicBins, DensityIsTheMeanShareOverTheSizesInABin) {
    AvalancheSizes sizes;
    sizes.add(2, 5);
    sizes.add(3, 1);
    sizes.add(7, 4);
    sizes.add(40, 10);
    const auto bins = sizes.logarithmic_bins(4);
    ASSERT_EQ(bins.size(), 6U);  // from 2–3 to 32–56
    EXPECT_EQ(bins[0].count, 6);
    EXPECT_DOUBLE_EQ(bins[0].density, 6.0 / 2.0 / 20.0);
    EXPECT_DOUBLE_EQ(bins[0].size, std::sqrt(6.0));
    EXPECT_EQ(bins[1].count, 0);
    EXPECT_EQ(bins[1].density, 0.0);
    EXPECT_DOUBLE_EQ(bins[2].density, 4.0 / 4.0 / 20.0);
    EXPECT_DOUBLE_EQ(bins[5].density, 10.0 / 25.0 / 20.0);
    double all = 0.0;
    for (const auto& bin : bins) all += bin.density * static_cast<double>(bin.high - bin.low + 1);
    EXPECT_DOUBLE_EQ(all, 1.0);
}

TEST(LogarithmicBins, ReachTheLargestSize) {
    AvalancheSizes sizes;
    sizes.add(largest_avalanche);
    for (const int bins_per_decade : {1, 8, 100}) {
        const auto bins = sizes.logarithmic_bins(bins_per_decade);
        ASSERT_EQ(bins.size(), 1U);
        EXPECT_EQ(bins[0].low, largest_avalanche);
        EXPECT_EQ(bins[0].count, 1);
    }
}

}  // namespace
}  // namespace fumon
