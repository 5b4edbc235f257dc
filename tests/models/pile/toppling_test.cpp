#include "models/pile/toppling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace fumon {
namespace {

int before_and_after(int before, int incoming) {
    return direction_after(DirectionRule::mean, before, incoming);
}

TEST(TopplingDirection, IsThePublishedMeanWithTable2) {
    for (const auto& [one, other, mean] : std::vector<std::array<int, 3>>{
             {1, 8, 8}, {2, 8, 1}, {3, 8, 1}, {1, 7, 8}, {2, 7, 8}, {1, 6, 7}}) {
        EXPECT_EQ(before_and_after(one, other), mean) << one << ", " << other;
        EXPECT_EQ(before_and_after(other, one), mean) << other << ", " << one;
    }
    for (int incoming = 1; incoming <= 8; ++incoming) {
        EXPECT_EQ(before_and_after(0, incoming), incoming);  // eq. (5)
        for (int before = 1; before <= 8; ++before) {
            if (std::abs(before - incoming) >= 5) continue;
            EXPECT_EQ(before_and_after(before, incoming), (before + incoming) / 2);
        }
    }
}

TEST(TopplingDirection, RoundedIsThatOfTable3) {
    const auto rounded = [](int before, int incoming) {
        return direction_after(DirectionRule::mean_rounded, before, incoming);
    };
    EXPECT_EQ(rounded(0, 4), 2);
    EXPECT_EQ(rounded(0, 5), 3);
    EXPECT_EQ(rounded(0, 6), 3);
    EXPECT_EQ(rounded(4, 5), 5);
    EXPECT_EQ(rounded(4, 6), 5);
    EXPECT_EQ(rounded(2, 8), 1);
    for (int before = 0; before <= 8; ++before) {
        for (int incoming = 1; incoming <= 8; ++incoming) {
            EXPECT_GE(rounded(before, incoming), 1);
            EXPECT_LE(rounded(before, incoming), 8);
        }
    }
}

TEST(TopplingDirection, CircularMeanIsHalfwayAndTheSameTurnedOrInAMirror) {
    const auto mean = [](int before, int incoming) {
        return direction_after(DirectionRule::circular_mean, before, incoming);
    };
    const auto mirrored = [](int direction) { return turned(1, -(direction - 1)); };
    EXPECT_EQ(mean(0, 6), 6);
    EXPECT_EQ(mean(1, 3), 2);
    EXPECT_EQ(mean(8, 2), 1);
    EXPECT_EQ(mean(1, 2), 2);
    EXPECT_EQ(mean(1, 4), 3);
    EXPECT_EQ(mean(4, 1), 2);
    EXPECT_EQ(mean(1, 5), 5);
    constexpr double eighth = 0.78539816339744831;
    for (int before = 1; before <= 8; ++before) {
        for (int incoming = 1; incoming <= 8; ++incoming) {
            for (int by = 0; by < 8; ++by) {
                EXPECT_EQ(mean(turned(before, by), turned(incoming, by)),
                          turned(mean(before, incoming), by));
            }
            EXPECT_EQ(mean(mirrored(before), mirrored(incoming)), mirrored(mean(before, incoming)));
            if ((incoming - before + 8) % 8 == 4) continue;
            // never further than half an eighth from the direction of the sum of both
            const double x = std::cos(eighth * before) + std::cos(eighth * incoming);
            const double y = std::sin(eighth * before) + std::sin(eighth * incoming);
            const double off =
                std::remainder(eighth * mean(before, incoming) - std::atan2(y, x), 8.0 * eighth);
            EXPECT_LE(std::abs(off), 0.5 * eighth + 1e-12) << before << ", " << incoming;
            // the other half step lies as far on the other side
            const int previous = direction_after(DirectionRule::circular_mean, before, incoming,
                                                 HalfStep::toward_previous);
            const double other = std::remainder(eighth * previous - std::atan2(y, x), 8.0 * eighth);
            EXPECT_NEAR(other, -off, 1e-12) << before << ", " << incoming;
        }
    }
}

TEST(Topple, SharesGrainsEvenly) {
    using Shares = std::array<int, 3>;
    EXPECT_EQ(shares_of(1), (Shares{0, 1, 0}));
    EXPECT_EQ(shares_of(2), (Shares{1, 0, 1}));
    EXPECT_EQ(shares_of(3), (Shares{1, 1, 1}));
    EXPECT_EQ(shares_of(4), (Shares{1, 2, 1}));
    EXPECT_EQ(shares_of(5), (Shares{2, 1, 2}));
    EXPECT_EQ(shares_of(6), (Shares{2, 2, 2}));
}

/// By trying: does a cell that topples toward one T lower end below it?
bool undercuts(int threshold, int grains) {
    const auto shares = shares_of(grains);
    for (const int share : shares) {
        if (share > 0 && threshold - grains < share) return true;
    }
    return false;
}

TEST(Topple, MayMoveAsManyGrainsAsUndercutNothing) {
    const std::array<std::int64_t, 11> expected{0, 0, 1, 2, 3, 3, 4, 5, 6, 6, 7};
    for (int threshold = 1; threshold <= 10; ++threshold) {
        const std::int64_t most = most_grains_per_topple(threshold);
        EXPECT_EQ(most, expected[static_cast<std::size_t>(threshold)]);
        for (int grains = 1; grains <= 12; ++grains)
            EXPECT_EQ(undercuts(threshold, grains), grains > most) << threshold << ", " << grains;
    }
}

}  // namespace
}  // namespace fumon
