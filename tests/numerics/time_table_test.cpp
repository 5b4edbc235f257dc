#include "numerics/time_table.h"

#include <gtest/gtest.h>

#include <vector>

namespace fumon {
namespace {

TEST(TimeTable, ValuesAreLinearAndStairsHold) {
    const std::vector<double> times{10.0, 20.0, 40.0};
    const std::vector<double> values{1.0, 3.0, 0.0};
    EXPECT_EQ(value_at(times, values, 0.0), 1.0);
    EXPECT_EQ(value_at(times, values, 15.0), 2.0);
    EXPECT_EQ(value_at(times, values, 30.0), 1.5);
    EXPECT_EQ(value_at(times, values, 99.0), 0.0);
    EXPECT_EQ(mean_of_steps(times, values, 0.0, 10.0), 0.0);
    EXPECT_EQ(mean_of_steps(times, values, 5.0, 15.0), 0.5);
    EXPECT_EQ(mean_of_steps(times, values, 15.0, 25.0), 2.0);
    EXPECT_EQ(mean_of_steps(times, values, 40.0, 50.0), 0.0);
}

}  // namespace
}  // namespace fumon
