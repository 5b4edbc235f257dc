#include "models/sandpile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "models/plain_pile.h"
#include "models/registry.h"
#include "models/toppling.h"
#include "support/error.h"
#include "support/worker_pool.h"
#include "terrain/random.h"

namespace fumon {
namespace {

SandpileParameters cycling() {
    SandpileParameters pile;
    pile.drop_direction = DropDirection::cycling;
    return pile;
}

/// A model, its pool and all its avalanches.
struct PileRun {
    WorkerPool pool{1};
    Sandpile model;
    std::vector<Avalanche> avalanches;

    PileRun(const SandpileParameters& parameters, Grid bed, std::uint64_t seed = 1)
        : model(parameters, {std::move(bed), {}, {}, seed, pool}) {}

    void step(int steps) {
        for (int done = 0; done < steps; ++done) {
            model.step();
            for (const Avalanche& one : model.avalanches()) avalanches.push_back(one);
        }
    }
    [[nodiscard]] std::int64_t topplings() const {
        std::int64_t sum = 0;
        for (const Avalanche& one : avalanches) sum += one.topplings;
        return sum;
    }
};

Grid flat(int nx, int ny) {
    return {nx, ny, 0.0};
}

/// Whole heights 0 … highest.
Grid rough(int nx, int ny, std::uint32_t highest, std::uint64_t seed) {
    Grid bed(nx, ny);
    RandomStream stream(seed, 0, 0, Purpose::initial_bed);
    for (double& height : bed.values()) height = stream.below(highest + 1);
    return bed;
}

double total(const Grid& bed) {
    return std::accumulate(bed.values().begin(), bed.values().end(), 0.0);
}

double number(const Snapshot& snapshot, const std::string& name) {
    for (const SnapshotNumber& one : snapshot.numbers) {
        if (one.name == name) return one.value;
    }
    ADD_FAILURE() << "no number " << name;
    return 0.0;
}

/// Names a case that failed.
std::string text(const SandpileParameters& pile) {
    return "direction " + std::to_string(static_cast<int>(pile.direction)) + ", toward " +
           std::to_string(static_cast<int>(pile.topple_toward)) + ", order " +
           std::to_string(static_cast<int>(pile.order)) + ", T " + std::to_string(pile.threshold) +
           ", g " + std::to_string(pile.grains_per_topple);
}

std::vector<SandpileParameters> all_rules() {
    std::vector<SandpileParameters> all;
    for (const auto& [threshold, grains] : std::vector<std::pair<int, int>>{
             {5, 3}, {4, 3}, {3, 2}, {2, 1}, {4, 2}, {6, 4}, {7, 5}, {10, 7}}) {
        for (const DirectionRule rule :
             {DirectionRule::mean, DirectionRule::mean_rounded, DirectionRule::circular_mean}) {
            for (const ToppleToward toward :
                 {ToppleToward::any_lower, ToppleToward::toward_direction}) {
                for (const ToppleOrder order :
                     {ToppleOrder::sweep, ToppleOrder::first_in_first_out}) {
                    SandpileParameters pile;
                    pile.threshold = threshold;
                    pile.grains_per_topple = grains;
                    pile.direction = rule;
                    pile.topple_toward = toward;
                    pile.order = order;
                    all.push_back(pile);
                }
            }
        }
    }
    return all;
}

// ---- the vector without randomness ----

struct Vector {
    int grains;
    double highest, resident;
    std::size_t avalanches;
    std::int64_t topplings;
};

class SandpileVectors : public testing::TestWithParam<Vector> {};

TEST_P(SandpileVectors, AreMetExactly) {
    const Vector& expected = GetParam();
    PileRun run(cycling(), flat(16, 16));
    run.step(expected.grains);
    const Grid bed = run.model.snapshot().bed;
    EXPECT_EQ(*std::max_element(bed.values().begin(), bed.values().end()), expected.highest);
    EXPECT_EQ(total(bed), expected.resident);
    EXPECT_EQ(run.avalanches.size(), expected.avalanches);
    EXPECT_EQ(run.topplings(), expected.topplings);
}

INSTANTIATE_TEST_SUITE_P(Centre, SandpileVectors,
                         testing::Values(Vector{1000, 16, 1000, 332, 2293},
                                         Vector{5000, 19, 2053, 1690, 52974}),
                         [](const auto& test) { return std::to_string(test.param.grains); });

// ---- against the plain double loop ----

/// With one grain per topple the published direction mean lets grains go round for ever on a rough
/// bed; see Sandpile.SaysWhenGrainsGoRoundForEver.
bool may_never_rest(const SandpileParameters& pile) {
    return pile.grains_per_topple == 1 && pile.direction == DirectionRule::mean &&
           pile.topple_toward == ToppleToward::any_lower;
}

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

// ---- one topple ----

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
        }
    }
}

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
                EXPECT_EQ(fault.exit_status(), 1);
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

std::string refusal(const SandpileParameters& pile, const Grid& bed, const Mask& nodata = {}) {
    WorkerPool pool(1);
    try {
        const Sandpile model(pile, {bed, nodata, {}, 1, pool});
    } catch (const KeyError& fault) {
        return fault.key() + ": " + fault.what();
    }
    return "(accepted)";
}

TEST(Sandpile, RefusesWhatDoesNotFit) {
    EXPECT_EQ(refusal({}, flat(9, 9), Mask(9, 9, 1)),
              "bed.file: the bed has cells without data, on which no grain can lie; write "
              "bed.nodata = \"fill\" or give them a height");
    EXPECT_EQ(refusal({}, Grid(9, 9, 0.375)),
              "bed.kind: a pile is made of whole grains, but the bed has a height of 0.375; write "
              "bed.kind = \"flat\", or give it whole heights from 0 to 1000000");
    EXPECT_NE(refusal({}, Grid(9, 9, -1.0)), "(accepted)");
    EXPECT_NE(refusal({}, Grid(9, 9, std::nan(""))), "(accepted)");
    EXPECT_NE(refusal({}, Grid(9, 9, 2e6)), "(accepted)");
    EXPECT_EQ(refusal({}, Grid(9, 9, 3.0)), "(accepted)");

    SandpileParameters pile;
    pile.threshold = 1;
    EXPECT_EQ(refusal(pile, flat(9, 9)),
              "model.threshold: model.threshold is 1; even a single grain would leave its cell "
              "below the one it falls on, so take 2 or more");
    pile = {};
    pile.grains_per_topple = 4;
    EXPECT_EQ(refusal(pile, flat(9, 9)),
              "model.grains_per_topple: model.grains_per_topple is 4 with model.threshold = 5: a "
              "cell that gives 4 may end below one that gets 2; take at most 3, or a threshold of "
              "6 or more");
    pile.threshold = 6;
    EXPECT_EQ(refusal(pile, flat(9, 9)), "(accepted)");

    pile = {};
    pile.drop_x = {4, 9};
    pile.drop_y = {4};
    EXPECT_EQ(refusal(pile, flat(9, 9)),
              "model.drop_y: model.drop_x has 2 numbers and model.drop_y 1; give each drop site "
              "both");
    pile.drop_y = {4, 4};
    EXPECT_EQ(refusal(pile, flat(9, 9)),
              "model.drop_x: model.drop_x names 9, off the grid of grid.nx = 9; it takes 0 to 8");
    pile.drop_x = {4, 8};
    EXPECT_EQ(refusal(pile, flat(9, 9)), "(accepted)");
}

TEST(Sandpile, IsListed) {
    EXPECT_NE(find_model("sandpile"), nullptr);
}

}  // namespace
}  // namespace fumon
