#include "measure/measured_values.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(MeasuredValues, ACopySharesThemAndKeepsItsLength) {
    MeasuredValues values{1.0, 2.0};
    const MeasuredValues before = values;
    values.push_back(3.0);
    EXPECT_EQ(before.data(), values.data()) << "nothing was copied";
    EXPECT_EQ(before.copied(), (std::vector{1.0, 2.0}));
    EXPECT_EQ(values.copied(), (std::vector{1.0, 2.0, 3.0}));
    EXPECT_EQ(values.back(), 3.0);
}

TEST(MeasuredValues, ManyCopiesOfAGrowingListTakeLittleMoreThanTheList) {
    MeasuredValues values;
    std::vector<MeasuredValues> copies;
    std::vector<const double*> stores;
    for (int i = 0; i < 100'000; ++i) {
        values.push_back(i);
        copies.push_back(values);
        if (stores.empty() || stores.back() != values.data()) stores.push_back(values.data());
    }
    EXPECT_LE(stores.size(), 12U) << "64, 128, 256 … values";
    for (std::size_t i = 0; i < copies.size(); i += 997) {
        ASSERT_EQ(copies[i].size(), i + 1);
        EXPECT_EQ(copies[i][i / 2], static_cast<double>(i / 2));
        EXPECT_EQ(copies[i].back(), static_cast<double>(i));
    }
}

TEST(MeasuredValues, CopiesThatBothGoOnGoTheirOwnWays) {
    MeasuredValues one{1.0};
    MeasuredValues other = one;
    one.push_back(2.0);
    other.push_back(3.0);
    EXPECT_EQ(one.copied(), (std::vector{1.0, 2.0}));
    EXPECT_EQ(other.copied(), (std::vector{1.0, 3.0}));
    EXPECT_TRUE(MeasuredValues().empty());
    EXPECT_TRUE(MeasuredValues().copied().empty());
}

}  // namespace
}  // namespace fumon
