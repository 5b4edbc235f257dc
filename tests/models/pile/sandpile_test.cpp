#include "models/pile/sandpile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/pile/toppling.h"
#include "models/registry.h"
#include "support/pile_run.h"
#include "support/plain_pile.h"
#include "support/snapshot_number.h"

namespace fumon {
namespace {

using test::number;

// ---- the vector without randomness ----

struct PileVector {
    int grains;
    double highest, resident;
    std::size_t avalanches;
    std::int64_t topplings;
};

void PrintTo(const PileVector& vector, std::ostream* out) {
    *out << vector.grains << " grains";
}

class SandpileVectors : public testing::TestWithParam<PileVector> {};

TEST_P(SandpileVectors, AreMetExactly) {
    const PileVector& expected = GetParam();
    PileRun run(cycling(), flat(16, 16));
    run.step(expected.grains);
    const Grid bed = run.model.snapshot().bed;
    EXPECT_EQ(*std::max_element(bed.values().begin(), bed.values().end()), expected.highest);
    EXPECT_EQ(total(bed), expected.resident);
    EXPECT_EQ(run.avalanches.size(), expected.avalanches);
    EXPECT_EQ(run.topplings(), expected.topplings);
}

INSTANTIATE_TEST_SUITE_P(Centre, SandpileVectors,
                         testing::Values(PileVector{1000, 16, 1000, 332, 2293},
                                         PileVector{5000, 19, 2053, 1690, 52974}),
                         [](const auto& test) { return std::to_string(test.param.grains); });

TEST(Topple, MovesGrainsToThreeCellsAroundTheDirection) {
    PileRun run(cycling(), flat(7, 7));  // the centre is (3, 3); direction 1 is north-west
    run.step(5);
    ASSERT_EQ(run.avalanches.size(), 1U);
    EXPECT_EQ(run.avalanches[0].grain, 5);
    EXPECT_EQ(run.avalanches[0].size, 4);
    EXPECT_EQ(run.avalanches[0].duration, 1);
    EXPECT_EQ(run.avalanches[0].topplings, 1);
    const Snapshot snapshot = run.model.snapshot();
    Grid bed = flat(7, 7);
    bed(3, 3) = 2.0;
    bed(2, 4) = bed(2, 3) = bed(3, 4) = 1.0;
    EXPECT_EQ(snapshot.bed, bed);
    bed(3, 3) = 2.0;  // toppled once
    EXPECT_EQ(snapshot.fields.at(0).values, bed);
    EXPECT_EQ(snapshot.fields.at(0).name, "last_avalanche");
    EXPECT_EQ(snapshot.time, 5.0);
    EXPECT_EQ(snapshot.time_unit, "grains");
    EXPECT_FALSE(snapshot.periodic);
    run.step(1);  // a grain that sets off nothing leaves the last avalanche on show
    EXPECT_TRUE(run.model.avalanches().empty());
    EXPECT_EQ(run.model.snapshot().fields.at(0).values, bed);
    EXPECT_EQ(number(run.model.snapshot(), "avalanches"), 1.0);

    const auto state = run.model.state();
    ASSERT_EQ(state.size(), 3U);
    EXPECT_EQ(state[0].name, "bed");
    EXPECT_EQ(state[1].name, "direction");
    const auto direction = [&](int x, int y) {
        return state[1].values[static_cast<std::size_t>(7 * y + x)];
    };
    EXPECT_EQ(direction(2, 3), 8.0);
    EXPECT_EQ(direction(2, 4), 1.0);
    EXPECT_EQ(direction(3, 4), 2.0);
    EXPECT_EQ(direction(3, 3), 9.0);
    EXPECT_EQ(direction(4, 3), 0.0);
}

// ---- laws ----

int unstable_cells(const SandpileParameters& pile, const Grid& bed,
                   std::span<const double> directions) {
    int count = 0;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const int own =
                static_cast<int>(directions[static_cast<std::size_t>(y * bed.nx() + x)]);
            bool unstable = false;
            for (int direction = 1; direction <= 8; ++direction) {
                const int to_x = x + ring_step(direction).dx;
                const int to_y = y - ring_step(direction).dy;
                const bool inside = to_x >= 0 && to_x < bed.nx() && to_y >= 0 && to_y < bed.ny();
                const double low = inside ? bed(to_x, to_y) : 0.0;
                if (looks_at(pile, own, direction) &&
                    bed(x, y) - low >= static_cast<double>(pile.threshold))
                    unstable = true;
            }
            count += unstable ? 1 : 0;
        }
    }
    return count;
}

TEST(Sandpile, ConservesGrainsAndComesToRestWithEveryRule) {
    for (SandpileParameters pile : all_rules()) {
        SCOPED_TRACE(text(pile));
        pile.grains_per_step = 40;
        const Grid start = may_never_rest(pile) ? flat(19, 14) : rough(19, 14, 30, 5);
        PileRun run(pile, start);
        for (int step = 1; step <= 40; ++step) {
            run.step(1);
            const Snapshot now = run.model.snapshot();
            ASSERT_EQ(total(start) + 40.0 * step, total(now.bed) + number(now, "lost_grains"));
        }
        EXPECT_GT(number(run.model.snapshot(), "lost_grains"), 0.0);
        const auto state = run.model.state();
        EXPECT_EQ(unstable_cells(pile, run.model.snapshot().bed, state[1].values), 0);
    }
}

TEST(Sandpile, SaysWhenGrainsGoRoundForEver) {
    SandpileParameters pile;
    pile.threshold = 2;
    pile.grains_per_topple = 1;
    for (const ToppleOrder order : {ToppleOrder::sweep, ToppleOrder::first_in_first_out}) {
        pile.order = order;
        int endless = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            PileRun run(pile, rough(19, 14, 30, seed), seed);
            try {
                run.step(500);
            } catch (const Error& fault) {
                EXPECT_NE(std::string(fault.what()).find("never comes to rest"), std::string::npos);
                EXPECT_EQ(fault.exit_status(), 3);
                ++endless;
            }
        }
        EXPECT_GT(endless, 0);
        EXPECT_LT(endless, 12);
    }
}

TEST(Sandpile, FallsOffAllFourEdges) {
    SandpileParameters pile;
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{0, 4}, {8, 4}, {4, 0}, {4, 8}}) {
        pile.drop_x = {x};
        pile.drop_y = {y};
        PileRun run(pile, flat(9, 9));
        run.step(300);
        std::int64_t lost = 0;
        for (const Avalanche& one : run.avalanches) lost += one.lost;
        EXPECT_GT(lost, 0);
        EXPECT_EQ(number(run.model.snapshot(), "lost_grains"), static_cast<double>(lost));
        const Grid bed = run.model.snapshot().bed;
        EXPECT_GT(bed(x, y), bed(8 - x, 8 - y)) << "the pile lies where grains fall";
    }
}

TEST(Sandpile, SitesTakeTurnsOrAreDrawn) {
    SandpileParameters pile;
    pile.drop_x = {2, 20, 11};
    pile.drop_y = {3, 4, 8};
    PileRun turns(pile, flat(24, 12));
    turns.step(8);
    const Grid bed = turns.model.snapshot().bed;
    EXPECT_EQ(bed(2, 3), 3.0);
    EXPECT_EQ(bed(20, 4), 3.0);
    EXPECT_EQ(bed(11, 8), 2.0);

    pile.drop_choice = DropChoice::random;
    pile.threshold = 1000;  // counts pile up
    PileRun drawn(pile, flat(24, 12));
    drawn.step(900);
    const Grid counts = drawn.model.snapshot().bed;
    EXPECT_EQ(counts(2, 3) + counts(20, 4) + counts(11, 8), 900.0);
    constexpr double five_deviations = 5.0 * 14.14;  // sqrt(900 · 1/3 · 2/3)
    for (std::size_t site = 0; site < 3; ++site) {
        const double count =
            counts(static_cast<int>(pile.drop_x[site]), static_cast<int>(pile.drop_y[site]));
        EXPECT_NEAR(count, 300.0, five_deviations);
    }
}

TEST(Sandpile, DropDirectionsAreUniform) {
    SandpileParameters pile;  // a single cell: grains 5, 8, 11 … topple it, and its losses tell
    pile.drop_x = {8};        // the direction by the neighbours that grew
    pile.drop_y = {8};
    std::array<int, 9> seen{};
    for (std::uint64_t seed = 1; seed <= 1600; ++seed) {
        PileRun run(pile, flat(17, 17), seed);
        run.step(5);
        const auto state = run.model.state();
        int sum = 0;
        int largest = 0;
        int smallest = 9;
        for (const double value : state[1].values) {
            const int direction = static_cast<int>(value);
            if (direction == 0 || direction == 9) continue;
            sum += direction;
            largest = std::max(largest, direction);
            smallest = std::min(smallest, direction);
        }
        const bool wraps = largest - smallest > 2;
        ++seen[static_cast<std::size_t>(!wraps ? sum / 3 : sum == 11 ? 1 : 8)];
    }
    for (std::size_t direction = 1; direction <= 8; ++direction)
        EXPECT_NEAR(seen[direction], 200, 5 * 13.2) << direction;
}

TEST(Sandpile, DependsOnTheGrainsDroppedAndNotOnTheirSteps) {
    for (const ToppleOrder order : {ToppleOrder::sweep, ToppleOrder::first_in_first_out}) {
        SandpileParameters pile;
        pile.order = order;
        pile.drop_x = {5, 11};
        pile.drop_y = {5, 6};
        pile.drop_choice = DropChoice::random;
        PileRun single(pile, rough(18, 13, 9, 6), 3);
        single.step(1200);
        pile.grains_per_step = 50;
        PileRun many(pile, rough(18, 13, 9, 6), 3);
        many.step(24);
        EXPECT_EQ(many.model.steps_done(), 24);
        EXPECT_EQ(many.model.time(), 1200.0);
        const auto one = single.model.state();
        const auto other = many.model.state();
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t field = 0; field < one.size(); ++field) {
            EXPECT_TRUE(std::equal(one[field].values.begin(), one[field].values.end(),
                                   other[field].values.begin(), other[field].values.end()))
                << one[field].name;
        }
        ASSERT_EQ(single.avalanches.size(), many.avalanches.size());
        for (std::size_t index = 0; index < single.avalanches.size(); ++index) {
            EXPECT_EQ(single.avalanches[index].grain, many.avalanches[index].grain);
            EXPECT_EQ(single.avalanches[index].size, many.avalanches[index].size);
        }
    }
}

TEST(Sandpile, IsTheSameOnEveryRunAndAnotherWithAnotherSeed) {
    const auto bed = [](std::uint64_t seed) {
        PileRun run({}, flat(24, 24), seed);
        run.step(4000);
        return run.model.snapshot().bed;
    };
    EXPECT_EQ(bed(1), bed(1));
    EXPECT_NE(bed(1), bed(2));
}

TEST(Sandpile, EveryRuleMakesADifference) {
    const auto bed = [](const SandpileParameters& pile) {
        PileRun run(pile, flat(24, 24));
        run.step(3000);
        return run.model.snapshot().bed;
    };
    const Grid standard = bed({});
    for (const auto& change : std::vector<void (*)(SandpileParameters&)>{
             [](auto& pile) { pile.order = ToppleOrder::first_in_first_out; },
             [](auto& pile) { pile.direction = DirectionRule::mean_rounded; },
             [](auto& pile) { pile.direction = DirectionRule::circular_mean; },
             [](auto& pile) { pile.topple_toward = ToppleToward::toward_direction; },
             [](auto& pile) { pile.drop_direction = DropDirection::cycling; },
             [](auto& pile) { pile.threshold = 6; },
             [](auto& pile) { pile.grains_per_topple = 2; }}) {
        SandpileParameters pile;
        change(pile);
        EXPECT_NE(bed(pile), standard) << text(pile);
    }
}

// ---- refusals ----

std::string pile_refusal(const SandpileParameters& pile, const Grid& bed, const Mask& nodata = {}) {
    WorkerPool pool(1);
    try {
        const Sandpile model(pile, {bed, nodata, {}, 1, pool});
    } catch (const KeyError& fault) {
        return fault.key() + ": " + fault.what();
    }
    return "(accepted)";
}

TEST(Sandpile, RefusesWhatDoesNotFit) {
    EXPECT_EQ(pile_refusal({}, flat(9, 9), Mask(9, 9, 1)),
              "bed.file: the bed has cells without data, on which no grain can lie; write "
              "bed.nodata = \"fill\" or give them a height");
    EXPECT_EQ(pile_refusal({}, Grid(9, 9, 0.375)),
              "bed.kind: a pile is made of whole grains, but the bed has a height of 0.375; write "
              "bed.kind = \"flat\", or give it whole heights from 0 to 1000000");
    EXPECT_NE(pile_refusal({}, Grid(9, 9, -1.0)), "(accepted)");
    EXPECT_NE(pile_refusal({}, Grid(9, 9, std::nan(""))), "(accepted)");
    EXPECT_NE(pile_refusal({}, Grid(9, 9, 2e6)), "(accepted)");
    EXPECT_EQ(pile_refusal({}, Grid(9, 9, 3.0)), "(accepted)");

    SandpileParameters pile;
    pile.threshold = 1;
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)),
              "model.threshold: model.threshold is 1; even a single grain would leave its cell "
              "below the one it falls on, so take 2 or more");
    pile = {};
    pile.grains_per_topple = 4;
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)),
              "model.grains_per_topple: model.grains_per_topple is 4 with model.threshold = 5: a "
              "cell that gives 4 may end below one that gets 2; take at most 3, or a threshold of "
              "6 or more");
    pile.threshold = 6;
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)), "(accepted)");

    pile = {};
    pile.drop_x = {4, 9};
    pile.drop_y = {4};
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)),
              "model.drop_y: model.drop_x has 2 numbers and model.drop_y 1; give each drop site "
              "both");
    pile.drop_y = {4, 4};
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)),
              "model.drop_x: model.drop_x names 9, off the grid of grid.nx = 9; it takes 0 to 8");
    pile.drop_x = {4, 8};
    EXPECT_EQ(pile_refusal(pile, flat(9, 9)), "(accepted)");
}

TEST(Sandpile, IsListed) {
    EXPECT_NE(find_model("sandpile"), nullptr);
}

}  // namespace
}  // namespace fumon
