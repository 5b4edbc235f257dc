#include "models/dunes/plants/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

ModelSetup level_sand(int nx, int ny, double thickness, WorkerPool& pool, double cell = 1.0) {
    return {Grid(nx, ny, thickness), {}, {cell, cell, 1.0, true}, 7, pool};
}

DuneGround square(int n, double cell = 1.0) {
    return {n, n, cell, cell, true, true};
}

DuneBed sand_on_rock(int n, double thickness) {
    DuneBed bed{FixedPointGrid(n, n, to_units(thickness)), FixedPointGrid(n, n),
                FixedPointGrid(n, n)};
    return bed;
}

/// Dunes on which plants grow, in a wind that shifts sand among them.
DunesParameters grown(double flux = 20.0) {
    DunesParameters dunes;
    dunes.plants = DunePlants::grow;
    dunes.flux = flux;
    dunes.grass.cover = 0.4;
    dunes.grass.share = 0.7;
    dunes.shrubs.cover = 0.3;
    dunes.shrubs.share = 0.5;
    dunes.growth_period = 0.02;
    dunes.features = {
        {FeatureKind::clearing, FeatureShape::hill, 20.0, 24.0, 30.0, 24.0, 0.0, 60.0},
        {FeatureKind::sand, FeatureShape::hill, 20.0, 24.0, 24.0, 20.0, 4.0, 60.0}};
    return dunes;
}

/// The numbers of Nield & Baas (2008) as they stand in the defaults.
TEST(Plants, GrowthFollowsThePublishedLaws) {
    const DunesParameters published;
    GrowthLaw grass{{}, published.grass.growth};
    std::copy_n(published.grass.balances.begin(), 5, grass.balances.begin());
    EXPECT_DOUBLE_EQ(grass.at(-1.4), -1.0);
    EXPECT_DOUBLE_EQ(grass.at(0.2), 0.0);
    EXPECT_DOUBLE_EQ(grass.at(0.6), 0.2);
    EXPECT_NEAR(grass.at(2.0), 0.0, 1e-15);
    EXPECT_NEAR(grass.at(2.2), -1.0, 1e-12);
    EXPECT_NEAR(grass.at(0.4), 0.1, 1e-15) << "half-way up";
    EXPECT_NEAR(grass.at(0.0), -0.125, 1e-15) << "without sand it dies back";
    EXPECT_NEAR(grass.at(2.4), -2.0, 1e-12) << "beyond the last point";
    GrowthLaw shrubs{{}, published.shrubs.growth};
    std::copy_n(published.shrubs.balances.begin(), 5, shrubs.balances.begin());
    EXPECT_DOUBLE_EQ(shrubs.at(-1.4), -1.0);
    EXPECT_DOUBLE_EQ(shrubs.at(-0.65), 0.0);
    EXPECT_DOUBLE_EQ(shrubs.at(0.0), 0.05);
    EXPECT_DOUBLE_EQ(shrubs.at(0.2), 0.0);
    EXPECT_DOUBLE_EQ(shrubs.at(2.8), -1.0);
    EXPECT_NEAR(shrubs.at(1.5), -0.5, 1e-15);
}

/// On ground that rises at a known rate.
TEST(Plants, CoverGrowsByTheBalanceSinceItLastDid) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.plants = DunePlants::grow;
    dunes.grass.cover = 0.5;
    dunes.shrubs.cover = 0.25;
    dunes.growth_period = 0.5;
    DuneBed bed = sand_on_rock(12, 1.0);
    Plants plants(dunes, square(12), bed, 1, pool);
    EXPECT_NEAR(plants.cover()(3, 3), 0.75, 1e-9);
    for (std::int64_t& height : bed.surface.values()) height += to_units(0.3);
    EXPECT_FALSE(plants.grow(bed, 0.4, 4)) << "before its time";
    EXPECT_TRUE(plants.grow(bed, 0.5, 5));
    EXPECT_NEAR(plants.grass()(3, 3), 0.6, 1e-9) << "0.6 m/yr for half a year: its best";
    EXPECT_NEAR(plants.shrubs()(3, 3), 0.25 - 0.5 * 0.4 / 2.6, 1e-9);
    for (std::int64_t& height : bed.surface.values()) height += to_units(4.0);
    EXPECT_TRUE(plants.grow(bed, 1.0, 10));
    EXPECT_EQ(plants.cover()(3, 3), 0.0) << "buried";
}

TEST(Plants, BeginBesideOthersAndFarFromThemAsOftenAsAsked) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.plants = DunePlants::grow;
    dunes.shrubs.cover = 0.5;
    dunes.growth_period = 1.0;
    constexpr int n = 400;
    dunes.features = {{FeatureKind::shrubs, FeatureShape::block, 50.0, 400.0, 100.0, 800.0, 0, 90}};
    const DuneBed bed = sand_on_rock(n, 1.0);
    Plants plants(dunes, square(n, 2.0), bed, 1, pool);
    EXPECT_NEAR(plants.cover()(10, 10), 0.5, 1e-9);
    EXPECT_EQ(plants.cover()(120, 10), 0.0);
    plants.grow(bed, 1.0, 100);
    int beside = 0;
    int far = 0;
    const Grid shrubs = plants.shrubs();
    for (int y = 0; y < n; ++y) {
        beside += (shrubs(50, y) > 0.0 ? 1 : 0) + (shrubs(n - 1, y) > 0.0 ? 1 : 0);
        for (int x = 60; x < 160; ++x) far += shrubs(x, y) > 0.0 ? 1 : 0;
    }
    // Pioneers .05 a square metre and year on 4 m², and .2 m a year over cells of 2 m.
    EXPECT_NEAR(far / 40000.0, 0.2, 0.008);
    EXPECT_NEAR(beside / 800.0, 0.2 + 0.1, 0.05) << beside;
    const Grid grass = plants.grass();
    EXPECT_EQ(*std::ranges::max_element(grass.values()), 0.0) << "none without burial";
}

TEST(Plants, NoneTakeRootOnRock) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.plants = DunePlants::grow;
    dunes.plant_pioneers = 100.0;
    dunes.growth_period = 1.0;
    DuneBed bed = sand_on_rock(10, 0.04);
    bed.surface(4, 4) = to_units(0.06);
    Plants plants(dunes, square(10), bed, 1, pool);
    plants.grow(bed, 1.0, 1);
    EXPECT_NEAR(plants.cover()(4, 4), 0.05, 1e-9);
    EXPECT_EQ(plants.cover()(5, 4), 0.0);
}

TEST(Plants, HoldSandInAllTransports) {
    WorkerPool pool(2);
    for (const DuneTransport transport : {DuneTransport::continuous, DuneTransport::slabs}) {
        for (const SlabOrder order : {SlabOrder::parallel, SlabOrder::sequential}) {
            DunesParameters dunes;
            dunes.transport = transport;
            dunes.order = order;
            dunes.speed_up = DuneSpeedUp::none;
            dunes.saturation_length = {"hops", 0.0};
            dunes.hop_length = 5.0;
            dunes.plants = DunePlants::fixed;
            dunes.plant_repose_angle = dunes.repose_angle;
            dunes.substeps = 64;
            dunes.slab_height = {"", 0.05};
            const auto moved = [&](double cover) {
                dunes.grass.cover = cover;
                Dunes model(dunes, level_sand(30, 20, 3.0, pool));
                model.step();
                double sum = 0.0;
                for (const std::int64_t height : model.bed().surface.values())
                    sum += std::abs(to_metres(height) - 3.0);
                return sum;
            };
            const double bare = moved(0.0);
            EXPECT_GT(bare, 0.0);
            EXPECT_GT(moved(0.3), 0.0);
            EXPECT_LT(moved(0.3), 0.75 * bare);
            EXPECT_EQ(moved(0.5), 0.0) << "where half the ground is covered nothing is lifted";
        }
    }
}

TEST(Plants, SandLiesMoreSteeplyUnderThem) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.plants = DunePlants::fixed;
    dunes.avalanche_passes = 100000;
    const auto steepest = [&](double cover) {
        dunes.grass.cover = cover;
        ModelSetup setup = level_sand(40, 40, 0.5, pool);
        for (int y = 14; y < 26; ++y) {
            for (int x = 14; x < 26; ++x) setup.bed(x, y) = 12.0;
        }
        dunes.flux = 1e-9;
        Dunes model(dunes, setup);
        model.step();
        EXPECT_EQ(model.plausibility_warning(), "");
        return SlopeRelaxation({40, 40}, {}, pool).steepest(model.bed().surface, model.bed().rock);
    };
    EXPECT_NEAR(steepest(0.0), 33.0, 0.5);
    EXPECT_NEAR(steepest(0.15), 39.0, 0.5) << "half-way to the cover of .3";
    EXPECT_NEAR(steepest(0.6), 45.0, 0.5);
}

TEST(Plants, CoverStaysBetweenNoneAndAllAndAnyThreadsGiveTheSame) {
    std::vector<Sha256> hashes;
    for (const int threads : {1, 2, 5}) {
        WorkerPool pool(threads);
        Dunes model(grown(), level_sand(64, 48, 1.0, pool));
        double least = 1.0;
        double most = 0.0;
        for (int step = 0; step < 40; ++step) {
            model.step();
            const Snapshot now = model.snapshot();
            for (const char* name : {"cover", "grass", "shrubs"}) {
                const auto field = std::ranges::find(now.fields, name, &SnapshotField::name);
                ASSERT_NE(field, now.fields.end());
                const auto [low, high] = std::ranges::minmax(field->values.values());
                least = std::min(least, low);
                most = std::max(most, high);
            }
        }
        EXPECT_EQ(least, 0.0);
        EXPECT_GT(most, 0.7);
        EXPECT_LE(most, 1.0);
        hashes.push_back(state_hash(model));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

/// A bare dune in a plain of grass and shrubs: plants hold its flanks, which fall behind its
/// middle, so that its arms trail upwind, against the wind as a parabola's.
TEST(Plants, ArmsOfAParabolicDuneTrailUpwind) {
    WorkerPool pool(2);
    constexpr int nx = 128;
    constexpr int ny = 64;
    const auto lag = [&](DunePlants plants) {
        DunesParameters dunes;
        dunes.plants = plants;
        dunes.saturation_length = {"hops", 0.0};
        dunes.flux = 15.0;
        dunes.slope_drift = 0.3;
        if (plants != DunePlants::none) {
            dunes.grass.cover = 0.6;
            dunes.shrubs.cover = 0.5;
            dunes.features.push_back(
                {FeatureKind::clearing, FeatureShape::hill, 24.0, 32.0, 32.0, 32.0, 0.0, 90.0});
        }
        dunes.features.push_back(
            {FeatureKind::sand, FeatureShape::hill, 26.0, 32.0, 32.0, 32.0, 4.0, 90.0});
        const double plain = plants != DunePlants::none ? 1.0 : 0.0;
        Dunes model(dunes, level_sand(nx, ny, plain, pool));
        for (int step = 0; step < 2200; ++step) model.step();
        // Sand that has come to lie on the plain: where it lies in the middle, and at its sides.
        double middle = 0.0;
        double sides = 0.0;
        double of_middle = 0.0;
        double of_sides = 0.0;
        for (int y = 0; y < ny; ++y) {
            const bool inner = std::abs(y - 31.5) < 5.0;
            for (int x = 0; x < nx; ++x) {
                const double above = to_metres(model.bed().surface(x, y)) - plain;
                if (above < 0.4) continue;
                (inner ? middle : sides) += above * x;
                (inner ? of_middle : of_sides) += above;
            }
        }
        return middle / of_middle - sides / of_sides;
    };
    EXPECT_GT(lag(DunePlants::grow), 3.0) << "the middle lies downwind of the arms";
    EXPECT_LT(lag(DunePlants::none), 0.0) << "a barchan's horns lie downwind of its middle";
}

TEST(Plants, WhatDoesNotFitIsRefused) {
    WorkerPool pool(1);
    const auto refusal = [&](const DunesParameters& dunes) {
        return message_of<KeyError>([&] { Dunes(dunes, level_sand(20, 20, 1.0, pool)); });
    };
    DunesParameters dunes;
    dunes.grass.cover = 0.5;
    EXPECT_NE(refusal(dunes).find("there are no plants"), std::string::npos);
    dunes = {};
    dunes.features = {{FeatureKind::clearing}};
    EXPECT_NE(refusal(dunes).find("there are no plants"), std::string::npos);
    dunes.plants = DunePlants::grow;
    EXPECT_EQ(refusal(dunes), "");
    dunes.plant_repose_angle = 30.0;
    EXPECT_NE(refusal(dunes).find("below model.repose_angle"), std::string::npos);
    dunes.plant_repose_angle = 45.0;
    dunes.shrubs.balances = {-1.4, -0.65, -0.65, 0.2, 2.8};
    EXPECT_NE(refusal(dunes).find("model.shrub_balances has -0.65 after -0.65"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
