// The way of water down a bed: straight down a plane, through a hollow, never round in a circle.

#include "measure/network/stream_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/random.h"

namespace fumon::test {
namespace {

TEST(StreamPath, GoesStraightDownAPlane) {
    Grid plane(9, 12);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 9; ++x) plane(x, y) = 2.0 * y + 0.01 * x;
    const StreamPath path = stream_path(route_flow(plane, {}, 3.0, 5.0), {}, 4, 10);
    ASSERT_EQ(path.x.size(), 11U);
    EXPECT_EQ(path.x.back(), 4);
    EXPECT_EQ(path.y.back(), 0);
    EXPECT_EQ(path.distance.back(), 50.0);
}

TEST(StreamPath, CrossesAHollowAndLeavesAtItsLowestBrim) {
    // A bowl with a notch in its eastern wall.
    Grid bowl(11, 11);
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x) bowl(x, y) = std::hypot(x - 5.0, y - 5.0);
    for (int x = 7; x < 11; ++x) bowl(x, 5) = 1.5;
    const StreamPath path = stream_path(route_flow(bowl, {}, 1.0, 1.0), {}, 2, 3);
    EXPECT_EQ(path.x.back(), 10);
    EXPECT_EQ(path.y.back(), 5);
}

TEST(StreamPath, EndsAtCellsWithoutData) {
    Grid plane(9, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) plane(x, y) = y;
    Mask nodata(9, 9);
    for (int x = 0; x < 9; ++x) nodata(x, 3) = 1;
    const FlowRouting routing = route_flow(plane, nodata, 1.0, 1.0);
    EXPECT_EQ(stream_path(routing, nodata, 4, 7).y.back(), 4);
    EXPECT_THROW(stream_path(routing, nodata, 4, 3), InputError);
    EXPECT_THROW(stream_path(routing, nodata, 9, 3), InputError);
}

TEST(StreamPath, NeverComesToACellTwiceOnRandomGround) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Grid ground(30, 20);
        for (int y = 0; y < 20; ++y) {
            RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
            for (double& height : ground.row(y)) height = std::floor(4.0 * stream.uniform());
        }
        const StreamPath path = stream_path(route_flow(ground, {}, 1.0, 2.0), {}, 15, 10);
        std::set<std::pair<int, int>> cells;
        for (std::size_t i = 0; i < path.x.size(); ++i) cells.insert({path.x[i], path.y[i]});
        EXPECT_EQ(cells.size(), path.x.size()) << seed;
        const bool at_rim = path.x.back() % 29 == 0 || path.y.back() % 19 == 0;
        EXPECT_TRUE(at_rim) << seed;
    }
}

}  // namespace
}  // namespace fumon::test
