#include "models/sand/sand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/worker_pool.h"
#include "measure/bed/bed_statistics.h"
#include "models/sand/maxima_creep.h"
#include "models/sand/profile_creep.h"

namespace fumon {
namespace {

Grid random_bed(int nx, int ny, double low, double high, std::uint64_t seed) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = low + (high - low) * stream.uniform();
    }
    return bed;
}

Grid after(const SandParameters& parameters, const Grid& bed, int steps, int threads = 2) {
    WorkerPool pool(threads);
    Sand sand(parameters, {bed, {}, {}, 1, pool});
    for (int step = 0; step < steps; ++step) sand.step();
    EXPECT_EQ(sand.steps_done(), steps);
    return sand.snapshot().bed;
}

SandParameters sudo() {
    SandParameters sand;
    sand.order = HopOrder::random_sequential;
    sand.hop_base = 3.0;
    sand.hop_per_height = 1.0;
    sand.landing = Landing::truncate;
    sand.limit_amount = false;
    sand.creep = Creep::maxima_only;
    sand.creep_rate = 0.1;
    return sand;
}

SandParameters dunes() {
    SandParameters sand;
    sand.hop_length = HopLength::slope;
    sand.hop_amount = HopAmount::slope;
    sand.landing = Landing::truncate;
    return sand;
}

// ---- the vectors without randomness ----

struct SandVector {
    std::string name;
    SandParameters parameters;
    int steps;
    double squares, h00, h32, h51;
};

void PrintTo(const SandVector& vector, std::ostream* out) {
    *out << vector.name;
}

SandParameters creep_alone(Creep creep) {
    SandParameters sand;
    sand.amount = 0.0;
    sand.creep = creep;
    sand.creep_rate = 0.1;
    return sand;
}

SandParameters ripples(Landing landing) {
    SandParameters sand;
    sand.landing = landing;
    return sand;
}

class SandVectors : public ::testing::TestWithParam<SandVector> {};

TEST_P(SandVectors, AreMetToTenDigits) {
    Grid bed(16, 12);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) bed(x, y) = 3.0 * ((7 * x + 13 * y + 3 * x * y) % 17) / 17.0;
    }
    const SandVector& expected = GetParam();
    const Grid found = after(expected.parameters, bed, expected.steps);
    double squares = 0.0;
    for (const double height : found.values()) squares += height * height;
    EXPECT_NEAR(squares, expected.squares, 2e-10 * expected.squares);
    EXPECT_NEAR(found(0, 0), expected.h00, 1e-10);
    EXPECT_NEAR(found(3, 2), expected.h32, 1e-10);
    EXPECT_NEAR(found(5, 1), expected.h51, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(
    All, SandVectors,
    ::testing::Values(SandVector{"start", ripples(Landing::round), 0, 596.8961937716, 0.0,
                                 2.4705882353, 2.1176470588},
                      SandVector{"maxima_only_creep", creep_alone(Creep::maxima_only), 3,
                                 560.9683938865, 0.0904534314, 2.0550183824, 1.7305720588},
                      SandVector{"every_cell_creep", creep_alone(Creep::every_cell), 3,
                                 529.0770740420, 0.3969747753, 2.0721678922, 1.7941609477},
                      SandVector{"ripples_truncated", ripples(Landing::truncate), 1, 556.0997359862,
                                 0.2202941176, 2.1605882353, 1.9301470588},
                      SandVector{"ripples_rounded", ripples(Landing::round), 20, 465.4362261638,
                                 1.1878520316, 1.2278098875, 1.6621619066},
                      SandVector{"dunes_central", dunes(), 20, 562.2105857811, 0.9948564948,
                                 0.8995708218, 2.3076933846}),
    [](const auto& test) { return test.param.name; });

// ---- every combination of options ----

std::vector<SandParameters> all_options() {
    std::vector<SandParameters> all;
    for (const HopOrder order : {HopOrder::synchronous, HopOrder::random_sequential}) {
        for (const HopLength length :
             {HopLength::linear, HopLength::slope, HopLength::exponential, HopLength::tabulated}) {
            for (const Landing landing :
                 {Landing::truncate, Landing::round, Landing::split, Landing::truncate_terms}) {
                for (const SlopeDifference difference :
                     {SlopeDifference::central, SlopeDifference::backward,
                      SlopeDifference::forward}) {
                    for (const Creep creep :
                         {Creep::every_cell, Creep::maxima_only, Creep::profile, Creep::none}) {
                        SandParameters sand;
                        sand.order = order;
                        sand.hop_length = length;
                        sand.hop_table_heights = {0.0, 1.0, 4.0};
                        sand.hop_table_lengths = {2.0, 5.5, 6.0};
                        sand.landing = landing;
                        sand.slope_difference = difference;
                        sand.creep = creep;
                        sand.hop_amount =
                            length == HopLength::slope ? HopAmount::slope : HopAmount::constant;
                        sand.shadow =
                            landing == Landing::split ? Shadow::upwind_higher : Shadow::none;
                        sand.limit_amount = difference != SlopeDifference::forward;
                        all.push_back(sand);
                    }
                }
            }
        }
    }
    return all;
}

TEST(Sand, IsConservedWithEveryOption) {
    const Grid bed = random_bed(31, 23, 0.5, 1.5, 2);
    const double before = bed_statistics(bed, {}).total;
    for (const SandParameters& sand : all_options()) {
        const double total = bed_statistics(after(sand, bed, 60), {}).total;
        EXPECT_NEAR(total, before, 1e-12 * before);
    }
}

TEST(Sand, TheSameForAnyNumberOfThreadsWithEveryOption) {
    const Grid bed = random_bed(31, 23, 0.5, 1.5, 3);
    for (const SandParameters& sand : all_options()) {
        const Grid one = after(sand, bed, 5, 1);
        for (const int threads : {2, 3, 8})
            EXPECT_EQ(after(sand, bed, 5, threads), one) << threads << " threads";
    }
}

TEST(Sand, EveryOptionMakesADifference) {
    const Grid bed = random_bed(31, 23, 0.0, 1.5, 4);
    const auto differs = [&](SandParameters base, auto change) {
        SandParameters changed = base;
        change(changed);
        return after(base, bed, 10) != after(changed, bed, 10);
    };
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.order = HopOrder::random_sequential; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.landing = Landing::split; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.landing = Landing::truncate; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.limit_amount = false; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.shadow = Shadow::upwind_higher; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.creep = Creep::none; }));
    EXPECT_TRUE(differs({}, [](auto& sand) { sand.creep = Creep::profile; }));
    SandParameters profile;
    profile.creep = Creep::profile;
    EXPECT_TRUE(differs(profile, [](auto& sand) { sand.flank_rate = 0.2; }));
    EXPECT_TRUE(
        differs(dunes(), [](auto& sand) { sand.slope_difference = SlopeDifference::backward; }));
    EXPECT_TRUE(
        differs(dunes(), [](auto& sand) { sand.slope_difference = SlopeDifference::forward; }));
    SandParameters broken_base = sudo();
    broken_base.hop_base = 2.75;  // with a whole L0 both truncations agree
    EXPECT_TRUE(differs(broken_base, [](auto& sand) { sand.landing = Landing::truncate_terms; }));
    EXPECT_FALSE(differs(sudo(), [](auto& sand) { sand.landing = Landing::truncate_terms; }));
}

TEST(Sand, ATableOfTheLinearLawIsTheLinearLaw) {
    SandParameters linear;
    SandParameters table;
    table.hop_length = HopLength::tabulated;
    table.hop_table_heights = {-1.0, 0.0, 0.5, 3.0};
    table.hop_table_lengths = {5.0, 5.0, 6.0, 11.0};  // L = 5 + 2 h between 0 and 3
    const Grid bed = random_bed(40, 30, 0.0, 1.0, 8);
    EXPECT_EQ(after(table, bed, 4), after(linear, bed, 4));
    table.hop_table_lengths.back() = 9.0;
    EXPECT_NE(after(table, bed, 4), after(linear, bed, 4));
}

TEST(Sand, OneRowAndHopsAroundTheBoxAreFine) {
    SandParameters sand;
    sand.hop_base = 7.0;  // the box is 7 wide: sand lands where it started, or further round
    const Grid bed = random_bed(7, 1, 0.0, 1.0, 5);
    sand.hop_per_height = 0.0;
    const Grid found = after(sand, bed, 5);
    EXPECT_NEAR(bed_statistics(found, {}).total, bed_statistics(bed, {}).total, 1e-13);
}

TEST(Sand, NothingStaysBelowZeroWhenAmountsAreLimited) {
    SandParameters sand;
    sand.amount = 0.9;
    const Grid found = after(sand, random_bed(40, 30, 0.0, 1.0, 6), 100);
    for (const double height : found.values()) EXPECT_GE(height, 0.0);
}

TEST(Sand, SaysWhenExponentialHopsHaveComeToGoRoundTheBox) {
    SandParameters sand;
    sand.hop_length = HopLength::exponential;
    sand.creep = Creep::none;
    sand.amount = 0.5;
    WorkerPool pool(1);
    Sand small(sand, {random_bed(100, 2, 0.0, 3.0, 5), {}, {}, 1, pool});
    EXPECT_EQ(small.plausibility_warning(), "") << "its first top hops within the box";
    std::string plausibility_warning;
    for (int step = 0; step < 200 && plausibility_warning.empty(); ++step) {
        small.step();
        plausibility_warning = small.plausibility_warning();
    }
    EXPECT_NE(plausibility_warning.find("round the box of 100: take a wider grid.nx"),
              std::string::npos)
        << plausibility_warning;
    EXPECT_EQ(plausibility_warning.find('\n'), std::string::npos);
}

// ---- maxima-only creep against the plain sweep ----

void plain_maxima_creep(Grid& bed, double rate) {
    const int nx = bed.nx();
    const int ny = bed.ny();
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double height = bed(x, y);
            const int w = (x + nx - 1) % nx;
            const int e = (x + 1) % nx;
            const int s = (y + ny - 1) % ny;
            const int n = (y + 1) % ny;
            const double around = std::max({bed(w, y), bed(e, y), bed(x, s), bed(x, n), bed(w, s),
                                            bed(w, n), bed(e, s), bed(e, n)});
            if (!(height > around)) continue;
            const double given = rate * height * 0.25;
            for (double* side : {&bed(w, y), &bed(e, y), &bed(x, s), &bed(x, n)})
                *side += given * (2.0 / 3.0);
            for (double* corner : {&bed(w, s), &bed(w, n), &bed(e, s), &bed(e, n)})
                *corner += given * (1.0 / 3.0);
            bed(x, y) -= rate * height;
        }
    }
}

void expect_plain_sweeps(Grid bed, double rate, int sweeps, WorkerPool& pool) {
    MaximaCreep creep;
    Grid scratch(bed.nx(), bed.ny());
    Grid plain = bed;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        creep(bed, scratch, rate, pool);
        plain_maxima_creep(plain, rate);
        ASSERT_EQ(bed, plain) << bed.nx() << " x " << bed.ny() << ", sweep " << sweep << ", "
                              << pool.size() << " threads";
    }
}

TEST(MaximaCreep, IsThePlainSweepBitForBit) {
    WorkerPool pool(2);
    for (const auto& [nx, ny] : std::vector<std::pair<int, int>>{{1, 1},
                                                                 {2, 3},
                                                                 {3, 3},
                                                                 {4, 5},
                                                                 {5, 2},
                                                                 {8, 8},
                                                                 {9, 7},
                                                                 {10, 4},
                                                                 {11, 16},
                                                                 {17, 5},
                                                                 {64, 9},
                                                                 {5, 34},
                                                                 {67, 41}}) {
        for (std::uint64_t seed = 1; seed <= 120; ++seed) {
            const double low = seed % 4 == 0 ? -1.0 : 0.0;  // beds of Sudo's rule dip below zero
            Grid bed = random_bed(nx, ny, low, 1.0 + low, seed);
            if (seed % 2 == 0) {  // plateaus: neighbours of the same height
                for (double& height : bed.values()) height = std::floor(height * 6.0);
            }
            const double rate =
                seed % 3 == 0 ? 0.9 : 0.1;  // large gifts make new maxima on the way
            SCOPED_TRACE(seed);
            expect_plain_sweeps(bed, rate, 4, pool);
        }
    }
}

TEST(MaximaCreep, IsThePlainSweepOnAnyNumberOfThreads) {
    for (const int threads : {1, 3, 7}) {
        WorkerPool pool(threads);
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            SCOPED_TRACE(seed);
            const double low = seed % 4 == 0 ? -1.0 : 0.0;
            expect_plain_sweeps(random_bed(130, 190, low, 1.0 + low, seed),
                                seed % 3 == 0 ? 0.9 : 0.1, 4, pool);
        }
    }
}

/// Each cell of a ridge becomes a maximum only by what the one before it gives, so that what a
/// part guesses of the row before it never comes true.
TEST(MaximaCreep, IsThePlainSweepWhereEachRowDependsOnAllBefore) {
    Grid ridge(66, 200);
    for (int y = 0; y < ridge.ny(); ++y) ridge(8, y) = y == 0 ? 1.1 : 1.0;
    WorkerPool pool(3);
    expect_plain_sweeps(ridge, 0.1, 1, pool);
    Grid after = ridge;
    plain_maxima_creep(after, 0.1);
    EXPECT_LT(after(8, 150), 1.0) << "the ridge has given all along";
    expect_plain_sweeps(ridge, 0.1, 5, pool);
}

// ---- the profile's creep against the plain sweep ----

void plain_profile_creep(std::span<double> row, double creep_rate, double flank_rate) {
    const std::size_t nx = row.size();
    for (std::size_t x = 0; x < nx; ++x) {
        double& left = row[(x + nx - 1) % nx];
        double& right = row[(x + 1) % nx];
        const double here = row[x];
        if (here > left && here > right) {
            left += creep_rate * here * 0.5;
            right += creep_rate * here * 0.5;
            row[x] -= creep_rate * here;
        } else if (here > left) {
            left += flank_rate * here;
            row[x] -= flank_rate * here;
        } else if (here > right) {
            right += flank_rate * here;
            row[x] -= flank_rate * here;
        }
    }
}

/// Noise, plateaus, a slope that never ends (where a guess never comes true), or one constant.
Grid profile_bed(int nx, std::uint64_t seed) {
    Grid bed = random_bed(nx, 1, 40.0, 60.0, seed);
    for (int x = 0; x < nx; ++x) {
        if (seed % 4 == 1) bed(x, 0) = std::floor(bed(x, 0) / 4.0);
        if (seed % 4 == 2) bed(x, 0) = 1e4 - 0.1 * x;
        if (seed % 4 == 3) bed(x, 0) = 50.0;
    }
    return bed;
}

TEST(ProfileCreep, IsThePlainSweepBitForBit) {
    WorkerPool one(1);
    WorkerPool two(2);
    WorkerPool five(5);
    for (const int nx : {1, 2, 3, 4, 5, 6, 17, 1000, 16384, 40000, 90001}) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            Grid plain = profile_bed(nx, seed);
            std::vector<Grid> fast(3, plain);
            for (int sweep = 0; sweep < 3; ++sweep) {
                plain_profile_creep(plain.row(0), 0.1, 0.05);
                std::size_t k = 0;
                for (WorkerPool* pool : {&one, &two, &five}) {
                    Grid swept(nx, 1);
                    profile_creep(fast[k].row(0), 0.1, 0.05, swept.row(0), pool);
                    ASSERT_EQ(swept, plain) << nx << " sites, seed " << seed << ", sweep " << sweep
                                            << ", " << pool->size() << " threads";
                    fast[k++] = swept;
                }
            }
        }
    }
}

TEST(Sand, ALongProfileIsTheSameForAnyNumberOfThreads) {
    SandParameters profile = sudo();
    profile.creep = Creep::profile;
    profile.hop_base = 50.0;
    const Grid bed = random_bed(50000, 1, 48.5, 51.5, 7);
    const Grid one = after(profile, bed, 20, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(after(profile, bed, 20, threads), one);
    EXPECT_NEAR(bed_statistics(one, {}).total, bed_statistics(bed, {}).total, 1e-6);
}

// ---- refusals ----

std::string sand_refusal(const SandParameters& sand, const Grid& bed, const Mask& nodata = {}) {
    WorkerPool pool(1);
    try {
        const Sand model(sand, {bed, nodata, {}, 1, pool});
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "(accepted)";
}

TEST(Sand, RefusesWhatDoesNotFit) {
    EXPECT_EQ(sand_refusal({}, Grid(10, 10, 1.0), Mask(10, 10, 1)),
              "the bed has cells without data, over which sand cannot hop; write bed.nodata = "
              "\"fill\" or give them a "
              "height");
    EXPECT_EQ(sand_refusal({}, Grid(10, 10, 4.0)),
              "the highest sand (4 heights of grid.height_unit = 1 m) would hop 13 sites, further "
              "than the box of 10; "
              "raise grid.height_unit, lower the bed or shorten the hops");
    EXPECT_EQ(sand_refusal(dunes(), Grid(9, 9, 1.0)),
              "hops of up to 10 sites (model.hop_base + model.hop_slope_factor) exceed the box of "
              "9 sites; take a wider "
              "grid or shorter hops");
    SandParameters fast_creep;
    fast_creep.creep_rate = 0.8;
    EXPECT_EQ(sand_refusal(fast_creep, Grid(20, 20, 1.0)),
              "model.creep_rate is 0.8; with every-cell creep it takes a number > 0 and ≤ 0.75");
    fast_creep.creep = Creep::maxima_only;
    EXPECT_EQ(sand_refusal(fast_creep, Grid(20, 20, 1.0)), "(accepted)");
    SandParameters table;
    table.hop_length = HopLength::tabulated;
    table.hop_table_heights = {0.0, 1.0, 1.0};
    table.hop_table_lengths = {2.0, 3.0};
    EXPECT_EQ(sand_refusal(table, Grid(20, 20, 1.0)),
              "the tabulated hop law needs at least two points, and a length for each height; "
              "there are 3 in model.hop_table_heights and 2 in model.hop_table_lengths");
    table.hop_table_lengths.push_back(4.0);
    EXPECT_EQ(sand_refusal(table, Grid(20, 20, 1.0)),
              "model.hop_table_heights must rise, but 1 follows 1");
}

}  // namespace
}  // namespace fumon
