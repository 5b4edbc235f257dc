#include "measure/network/level_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

#include "base/random.h"

namespace fumon {
namespace {

TEST(LevelQueue, LetsOutTheLowestAndOfEqualOnesTheFirst) {
    RandomStream chance(7, 0, 0, Purpose::plain);
    LevelQueue queue;
    std::set<std::tuple<double, std::int32_t, std::int32_t>> sorted;
    std::int32_t number = 0;
    const auto push = [&](double level) {
        const std::int32_t cell = 1000 - number;
        queue.push(level, cell);
        sorted.emplace(level, number++, cell);
    };
    for (int i = 0; i < 50; ++i) push(std::floor(6.0 * chance.uniform()));
    int at_level = 0;
    while (!sorted.empty()) {
        ASSERT_FALSE(queue.empty());
        const LevelQueue::Entry left = queue.pop();
        const auto [level, came, cell] = *sorted.begin();
        sorted.erase(sorted.begin());
        ASSERT_EQ(left.level, level);
        ASSERT_EQ(left.number, came);
        ASSERT_EQ(left.cell, cell);
        // As a flood does: some at the level that left, some higher.
        for (int i = 0; i < 2 && number < 400; ++i) {
            const double rise = std::max(std::floor(4.0 * chance.uniform()) - 1.0, 0.0);
            if (rise == 0.0) ++at_level;
            push(level + rise);
        }
    }
    EXPECT_TRUE(queue.empty());
    EXPECT_GT(at_level, 50);
}

}  // namespace
}  // namespace fumon
