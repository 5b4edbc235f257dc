// A row's hops against the rules written down one cell at a time.

#include "models/sand/row_hops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"

namespace fumon {
namespace {

using Row = std::vector<double>;

Row uneven(int nx) {
    Row row(static_cast<std::size_t>(nx));
    RandomStream stream(7, 0, 0, Purpose::initial_bed);
    for (double& height : row) height = 0.2 + 2.0 * stream.uniform();
    return row;
}

/// ∂h/∂x at a cell of a row that goes round.
double plain_slope(const SandParameters& p, const Row& row, int x) {
    const int nx = static_cast<int>(row.size());
    const auto at = [&](int cell) { return row[static_cast<std::size_t>((cell + nx) % nx)]; };
    if (p.slope_difference == SlopeDifference::forward) return at(x + 1) - at(x);
    if (p.slope_difference == SlopeDifference::backward) return at(x) - at(x - 1);
    return (at(x + 1) - at(x - 1)) / 2.0;
}

/// Takes the sand of one hop from `to` and lands it there, as `from` lies.
void plain_hop(const SandParameters& p, const Row& from, int x, Row& to) {
    const int nx = static_cast<int>(from.size());
    const auto place = [&](int cell) { return static_cast<std::size_t>((cell + nx) % nx); };
    const double height = from[place(x)];
    const double slope = plain_slope(p, from, x);
    double amount = p.amount;
    if (p.hop_amount == HopAmount::slope)
        amount = std::max(0.0, p.amount + p.amount_slope_factor * std::tanh(slope));
    if (p.limit_amount) amount = std::min(amount, height);
    if (p.shadow == Shadow::upwind_higher && from[place(x - 1)] > height) amount = 0.0;
    double length = p.hop_base + p.hop_per_height * height;
    if (p.landing == Landing::truncate_terms)
        length = p.hop_base + std::trunc(p.hop_per_height * height);
    if (p.hop_length == HopLength::slope)
        length = std::max(0.0, p.hop_base - p.hop_slope_factor * std::tanh(slope));
    if (p.landing == Landing::round) length = std::floor(length + 0.5);
    const int whole = static_cast<int>(std::floor(length));
    const double beyond = p.landing == Landing::split ? length - whole : 0.0;
    to[place(x)] -= amount;
    to[place(x + whole)] += amount * (1.0 - beyond);
    to[place(x + whole + 1)] += amount * beyond;
}

std::vector<SandParameters> laws() {
    std::vector<SandParameters> all;
    for (const HopLength length : {HopLength::linear, HopLength::slope}) {
        for (const Landing landing :
             {Landing::truncate, Landing::round, Landing::split, Landing::truncate_terms}) {
            for (const SlopeDifference difference :
                 {SlopeDifference::central, SlopeDifference::backward, SlopeDifference::forward}) {
                for (const Shadow shadow : {Shadow::none, Shadow::upwind_higher}) {
                    SandParameters sand;
                    sand.hop_length = length;
                    sand.hop_amount =
                        length == HopLength::slope ? HopAmount::slope : HopAmount::constant;
                    sand.landing = landing;
                    sand.slope_difference = difference;
                    sand.shadow = shadow;
                    sand.amount = 0.3;
                    sand.hop_base = 2.75;
                    all.push_back(sand);
                }
            }
        }
    }
    return all;
}

std::string told(const SandParameters& p, int nx) {
    return "length " + std::to_string(static_cast<int>(p.hop_length)) + ", landing " +
           std::to_string(static_cast<int>(p.landing)) + ", difference " +
           std::to_string(static_cast<int>(p.slope_difference)) + ", shadow " +
           std::to_string(static_cast<int>(p.shadow)) + ", " + std::to_string(nx) + " sites";
}

void expect_same(const Row& found, const Row& expected, const std::string& what) {
    for (std::size_t x = 0; x < found.size(); ++x)
        ASSERT_NEAR(found[x], expected[x], 1e-12) << what << ", site " << x;
}

TEST(RowHops, AllAtOnceAreTheRulesCellByCell) {
    for (const int nx : {5, 19}) {
        const Row before = uneven(nx);
        for (const SandParameters& sand : laws()) {
            Row expected = before;
            for (int x = 0; x < nx; ++x) plain_hop(sand, before, x, expected);
            Row found(before.size());
            RowHops(sand, nx).synchronous(before, found);
            expect_same(found, expected, told(sand, nx));
        }
    }
}

TEST(RowHops, OneAfterTheOtherAreTheRulesCellByCell) {
    for (const int nx : {5, 19}) {
        for (const SandParameters& sand : laws()) {
            Row found = uneven(nx);
            Row expected = found;
            const RowHops hops(sand, nx);
            for (const int count : {1, 1, 1, 31, 33, 70}) {  // more than are worked out ahead
                Picks picks;
                picks.draw(count, nx, 3, 0, count);
                hops.random_sequential(found, picks);
                for (const std::int32_t x : picks.cells()) {
                    const Row before = expected;
                    plain_hop(sand, before, x, expected);
                }
                expect_same(found, expected, told(sand, nx));
                expected = found;  // a difference in the last place would grow
            }
        }
    }
}

TEST(Picks, AreTheUpperHalvesOfWordsButForThoseThatFavourCells) {
    for (const int nx : {1, 5, 1024, 1'000'000, 2'000'000'011}) {
        constexpr std::int64_t count = 1000;
        RandomStream words(3, 4, 5, Purpose::picks);
        std::vector<std::uint64_t> first;
        for (std::int64_t k = 0; k < count; ++k) first.push_back(words.next32());
        Picks picks;
        picks.draw(count, nx, 3, 4, 5);
        ASSERT_EQ(picks.cells().size(), first.size());
        const std::uint64_t cells = static_cast<std::uint64_t>(nx);
        const std::uint64_t favoured = (std::uint64_t{1} << 32) % cells;
        for (std::size_t k = 0; k < first.size(); ++k) {
            std::uint64_t product = first[k] * cells;
            while (product % (std::uint64_t{1} << 32) < favoured) product = words.next32() * cells;
            ASSERT_EQ(static_cast<std::uint64_t>(picks.cells()[k]), product >> 32) << nx;
        }
    }
}

}  // namespace
}  // namespace fumon
