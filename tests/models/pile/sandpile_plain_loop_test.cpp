// The fast pile against the plain double loop, grain by grain.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "models/pile/sandpile.h"
#include "support/pile_run.h"
#include "support/plain_pile.h"
#include "support/snapshot_number.h"

namespace fumon {
namespace {

using test::number;

/// Grain by grain: heights, directions, avalanches and losses.
void compare(const SandpileParameters& parameters, const Grid& bed, int grains,
             std::uint64_t seed) {
    SCOPED_TRACE(text(parameters) + ", " + std::to_string(bed.nx()) + " x " +
                 std::to_string(bed.ny()));
    PileRun run(parameters, bed, seed);
    PlainPile plain(parameters, bed, seed);
    plain.settle();
    for (int grain = 1; grain <= grains; ++grain) {
        run.model.step();
        const Avalanche expected = plain.drop();
        const Avalanche found =
            run.model.avalanches().empty() ? Avalanche{} : run.model.avalanches().front();
        ASSERT_EQ(found.size, expected.size) << "grain " << grain;
        ASSERT_EQ(found.duration, expected.duration) << "grain " << grain;
        ASSERT_EQ(found.topplings, expected.topplings) << "grain " << grain;
        ASSERT_EQ(found.lost, expected.lost) << "grain " << grain;
        ASSERT_EQ(found.grain, expected.size > 0 ? grain : 0);
        if (expected.size > 0 || grain == 1 || grain == grains) {
            ASSERT_EQ(run.model.snapshot().bed, plain.heights()) << "grain " << grain;
        }
    }
    const Snapshot end = run.model.snapshot();
    EXPECT_EQ(end.fields.at(0).values, plain.changes());
    EXPECT_EQ(number(end, "lost_grains"), static_cast<double>(plain.lost()));
    EXPECT_EQ(number(end, "dropped_grains"), grains);
}

TEST(Sandpile, IsThePlainLoopWithEveryRule) {
    for (SandpileParameters pile : all_rules()) {
        compare(pile, flat(16, 16), 2500, 7);
        pile.drop_x = {1, 9, 6};
        pile.drop_y = {3, 0, 3};
        compare(pile, may_never_rest(pile) ? flat(13, 6) : rough(13, 6, 40, 3), 600, 8);
    }
}

TEST(Sandpile, IsThePlainLoopOnManyShapes) {
    for (const ToppleOrder order : {ToppleOrder::sweep, ToppleOrder::first_in_first_out}) {
        SandpileParameters pile;
        pile.order = order;
        for (const auto& [nx, ny] : std::vector<std::pair<int, int>>{
                 {1, 1}, {1, 9}, {2, 2}, {3, 7}, {62, 5}, {63, 4}, {64, 3}, {65, 9}, {5, 130}}) {
            compare(pile, flat(nx, ny), 2000, 2);
            compare(pile, rough(nx, ny, 90, 4), 300, 5);
        }
        compare(pile, flat(33, 32), 9000, 3);
        pile.drop_choice = DropChoice::random;
        pile.drop_x = {0, 69, 35, 0};  // corners, edges, and the first twice as often
        pile.drop_y = {0, 8, 0, 0};
        compare(pile, flat(70, 9), 5000, 4);
    }
}

TEST(Sandpile, IsThePlainLoopOnABedAsLargeAsItsSetOfWaitingCellsHasLevels) {
    Grid bed = flat(301, 300);  // more than 64 · 64 words
    for (int y = 40; y < 260; ++y) {
        for (int x = 40; x < 260; ++x)
            bed(x, y) = std::floor(std::max(0.0, 60.0 - 0.6 * std::hypot(x - 150.0, y - 149.0)));
    }
    for (const int hill : {60, 200}) bed(hill, hill) = 500.0;
    compare({}, bed, 40, 1);
}

}  // namespace
}  // namespace fumon
