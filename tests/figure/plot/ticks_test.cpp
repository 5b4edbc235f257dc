#include "figure/plot/ticks.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(Ticks, StandAtRoundNumbersWithinTheRange) {
    EXPECT_EQ(linear_ticks(0.0, 1.0, 6).labels,
              (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(linear_ticks(-0.023, 0.023, 5).labels,
              (std::vector<std::string>{"−0.02", "−0.01", "0.00", "0.01", "0.02"}));
    EXPECT_EQ(linear_ticks(130.0, 5200.0, 6).labels,
              (std::vector<std::string>{"1000", "2000", "3000", "4000", "5000"}));
}

TEST(Ticks, AreAtLeastOneAndNeverTooMany) {
    for (double high = 1.3e-7; high < 1e9; high *= 3.7) {
        for (const double low : {0.0, -high, 0.4 * high}) {
            for (const int most : {2, 3, 5, 8}) {
                const Ticks ticks = linear_ticks(low, high, most);
                EXPECT_GE(ticks.values.size(), 1U);
                EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most));
                for (const double value : ticks.values) {
                    EXPECT_GE(value, low - 1e-8 * high);
                    EXPECT_LE(value, high * (1.0 + 1e-8));
                }
            }
        }
    }
}

TEST(Ticks, AreNoneOfAnEmptyRange) {
    EXPECT_TRUE(linear_ticks(1.0, 1.0, 5).values.empty());
    EXPECT_TRUE(logarithmic_ticks(0.0, 1.0, 5).values.empty());
}

TEST(Ticks, OfALogarithmicAxisArePowersOfTen) {
    EXPECT_EQ(logarithmic_ticks(0.01, 100.0, 5).labels,
              (std::vector<std::string>{"10⁻²", "10⁻¹", "10⁰", "10¹", "10²"}));
    EXPECT_EQ(logarithmic_ticks(1.0, 1e8, 5).labels,
              (std::vector<std::string>{"10⁰", "10²", "10⁴", "10⁶", "10⁸"}));
}

}  // namespace
}  // namespace fumon
