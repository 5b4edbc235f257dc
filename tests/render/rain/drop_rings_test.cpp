#include "render/rain/drop_rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fumon {
namespace {

/// In a hundred moments, far enough apart that no drop is counted twice.
double drops_in_rain(double rate) {
    std::size_t count = 0;
    for (int i = 0; i < 100; ++i) count += fallen_drops(7.0 + 1.3 * i, rate).size();
    return static_cast<double>(count) / 100.0;
}

TEST(DropRings, TwiceTheRainHasTwiceTheDrops) {
    const double lighter = drops_in_rain(30.0);
    EXPECT_NEAR(drops_in_rain(60.0) / lighter, 2.0, 0.05);
    const double expected =
        ring_drop_rate(30.0) / ring_layers * ring_tile_m * ring_tile_m * ring_lifetime_s;
    EXPECT_NEAR(lighter / expected, 1.0, 0.03);
}

TEST(DropRings, NoRainHasNone) {
    EXPECT_TRUE(fallen_drops(100.0, 0.0).empty());
}

TEST(DropRings, ADropIsTheSameOneInTheNextFrame) {
    constexpr double frame = 1.0 / 30.0;
    const std::vector<FallenDrop> before = fallen_drops(1200.1, 50.0);
    const std::vector<FallenDrop> after = fallen_drops(1200.1 + frame, 50.0);
    std::size_t lasting = 0;
    for (const FallenDrop& drop : before) {
        if (drop.age + frame >= ring_lifetime_s) continue;
        ++lasting;
        EXPECT_TRUE(std::ranges::any_of(after, [&](const FallenDrop& later) {
            return later.x == drop.x && later.y == drop.y && later.age > drop.age;
        }));
    }
    EXPECT_GT(lasting, 100U);
}

TEST(DropRings, FromAfarATileIsEvenlyRoughMoreSoInHeavierRain) {
    const auto far = [](double rate) { return ring_tile_levels(1200.0, rate).back(); };
    const std::vector<std::uint8_t> heavy = far(60.0);
    ASSERT_EQ(heavy.size(), 4U);
    EXPECT_NEAR(heavy[0], 128, 2);
    EXPECT_NEAR(heavy[1], 128, 2);
    EXPECT_GT(heavy[2], far(15.0)[2]);
    EXPECT_GT(far(15.0)[2], 0);
}

}  // namespace
}  // namespace fumon
