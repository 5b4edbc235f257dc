#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/dunes/abrasion_reach.h"
#include "models/dunes/dunes.h"
#include "models/dunes/setup/ground_features.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

ModelSetup thin_sand(int nx, int ny, double thickness, WorkerPool& pool) {
    return {Grid(nx, ny, thickness), {}, {1.0, 1.0, 1.0, true}, 7, pool};
}

std::int64_t units_of(const FixedPointGrid& grid) {
    return std::accumulate(grid.values().begin(), grid.values().end(), std::int64_t{0});
}

std::int64_t sand_less_sources(const DuneBed& bed) {
    return units_of(bed.surface) - units_of(bed.rock) + units_of(bed.moving) + bed.outflow -
           bed.inflow - bed.worn;
}

struct Axes {
    double ratio;  ///< of the standard deviations along and across
    double angle;  ///< degrees from x
    double head;   ///< by how many of the former its middle lies beyond its top, along x
};

/// Of the cells that stand out of the plain by more than a third of the greatest height over it.
Axes axes_of_hill(const FixedPointGrid& rock) {
    std::vector<std::int64_t> heights(rock.values().begin(), rock.values().end());
    std::ranges::sort(heights);
    const std::int64_t plain = heights[heights.size() / 2];
    const std::int64_t least = plain + (heights.back() - plain) / 3;
    std::vector<std::pair<double, double>> cells;
    double mean_x = 0.0;
    double top_x = 0.0;
    double mean_y = 0.0;
    for (int y = 0; y < rock.ny(); ++y) {
        for (int x = 0; x < rock.nx(); ++x) {
            if (rock(x, y) <= least) continue;
            cells.emplace_back(x, y);
            if (rock(x, y) == heights.back()) top_x = x;
            mean_x += x;
            mean_y += y;
        }
    }
    const auto count = static_cast<double>(cells.size());
    mean_x /= count;
    mean_y /= count;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    for (const auto& [x, y] : cells) {
        xx += (x - mean_x) * (x - mean_x) / count;
        yy += (y - mean_y) * (y - mean_y) / count;
        xy += (x - mean_x) * (y - mean_y) / count;
    }
    const double mean = 0.5 * (xx + yy);
    const double apart = std::hypot(0.5 * (xx - yy), xy);
    return {std::sqrt((mean + apart) / (mean - apart)),
            0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::acos(-1.0),
            (mean_x - top_x) / std::sqrt(xx)};
}

TEST(WornRock, SandOutflowInflowAndWornRockBalanceExactly) {
    for (const bool open : {false, true}) {
        std::vector<Sha256> hashes;
        for (const int threads : {1, 2, 5}) {
            WorkerPool pool(threads);
            DunesParameters dunes;
            dunes.rock_wear = 0.02;
            if (open) dunes.abrasion_height = {"", 0.5};
            dunes.rock_dust = open ? 0.7 : 0.0;
            dunes.edges_x = open ? DuneEdge::open : DuneEdge::periodic;
            dunes.influx = 0.5;
            dunes.winds = {{270.0, 1.0, 0.01}, {20.0, 1.3, 0.005}};
            dunes.wall_angle = {"", 55.0};
            dunes.wall_drift = open ? 0.6 : 0.0;
            dunes.plants = DunePlants::grow;
            dunes.shrubs.cover = 0.4;
            dunes.shrubs.share = 0.1;
            dunes.features = {
                {FeatureKind::rock, FeatureShape::block, 30.0, 20.0, 8.0, 12.0, 6.0, 70.0},
                {FeatureKind::rock, FeatureShape::cone, 48.0, 28.0, 10.0, 10.0, 4.0, 90.0}};
            Dunes model(dunes, thin_sand(64, 40, 0.08, pool));
            const std::int64_t first = sand_less_sources(model.bed());
            const std::int64_t rock = units_of(model.bed().rock);
            for (int step = 0; step < 50; ++step) {
                model.step();
                ASSERT_EQ(sand_less_sources(model.bed()), first) << step;
                ASSERT_EQ(rock - units_of(model.bed().rock), model.bed().worn);
            }
            EXPECT_GT(to_metres(model.bed().worn), 1.0);
            EXPECT_EQ(model.bed().outflow > 0, open);
            for (std::size_t cell = 0; cell < model.bed().surface.size(); ++cell) {
                ASSERT_GE(model.bed().surface.values()[cell], model.bed().rock.values()[cell]);
                ASSERT_GE(model.bed().moving.values()[cell], 0);
            }
            hashes.push_back(state_hash(model));
        }
        EXPECT_EQ(hashes[0], hashes[1]);
        EXPECT_EQ(hashes[0], hashes[2]);
    }
}

TEST(WornRock, LevelRockLosesItsShareOfWhatLands) {
    WorkerPool pool(1);
    const DuneGround ground{20, 10, 1.0, 1.0, true, true};
    RockWear rock(ground, {0.01, std::tan(68.0 * std::acos(-1.0) / 180.0)}, pool);
    DuneBed bed{FixedPointGrid(20, 10), FixedPointGrid(20, 10), FixedPointGrid(20, 10)};
    bed.surface(7, 4) = to_units(0.025);
    bed.surface(9, 4) = to_units(0.06);
    const WindSchedule turns({{270.0, 1.0, 1.0}}, [](double) { return 1.0; });
    Grid cover(20, 10);
    cover(3, 4) = 0.75;
    rock.wear(bed, turns.at(0), FixedPointGrid(20, 10, to_units(0.4)), 0.5, &cover);
    EXPECT_NEAR(to_metres(bed.rock(2, 2)), -0.002, 1e-9);
    EXPECT_NEAR(to_metres(bed.surface(2, 2)), -0.002, 1e-9);
    EXPECT_NEAR(to_metres(bed.moving(2, 2)), 0.002, 1e-9);
    EXPECT_NEAR(to_metres(bed.rock(7, 4)), -0.001, 1e-9) << "half sheltered by sand";
    EXPECT_EQ(bed.rock(9, 4), 0) << "under sand";
    EXPECT_NEAR(to_metres(bed.rock(3, 4)), -0.0005, 1e-9) << "under plants";
    EXPECT_EQ(bed.worn, -units_of(bed.rock));
}

TEST(WornRock, SlopesThatFaceTheWindLoseMost) {
    WorkerPool pool(1);
    const DuneGround ground{40, 10, 1.0, 1.0, true, true};
    RockWear rock(ground, {0.01, std::tan(68.0 * std::acos(-1.0) / 180.0)}, pool);
    DuneBed bed{FixedPointGrid(40, 10), FixedPointGrid(40, 10), FixedPointGrid(40, 10)};
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 40; ++x) bed.rock(x, y) = to_units(0.4 * (x < 20 ? x : 40 - x));
    }
    bed.surface = bed.rock;
    const FixedPointGrid first = bed.rock;
    const WindSchedule turns({{270.0, 1.0, 1.0}}, [](double) { return 1.0; });
    rock.wear(bed, turns.at(0), FixedPointGrid(40, 10, to_units(0.1)), 1.0, nullptr);
    EXPECT_NEAR(to_metres(first(10, 5) - bed.rock(10, 5)), 0.003, 1e-9) << "1 + .4 / .2";
    EXPECT_EQ(bed.rock(30, 5), first(30, 5)) << "in the lee";
}

TEST(WornRock, GrainsReachWhatRisesGentlyAndHardlyAbove) {
    const DuneGround ground{60, 60, 1.0, 1.0, true, true};
    FixedPointGrid surface(60, 60);
    for (int y = 25; y < 35; ++y) {
        for (int x = 20; x < 40; ++x) surface(x, y) = to_units(2.0);
    }
    const double climb = std::tan(15.0 * std::acos(-1.0) / 180.0);
    for (const double from : {270.0, 90.0}) {
        const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
        WorkerPool pool(2);
        AbrasionReach reach(ground, 0.5, pool);
        reach.find(surface, turns.at(0));
        const auto above = [&](int x, int y) { return -0.5 * std::log(reach.share()(x, y)); };
        EXPECT_NEAR(above(10, 30), 0.0, 1e-9) << "on the plain";
        const int front = from == 270.0 ? 20 : 39;
        const int back = from == 270.0 ? 39 : 20;
        EXPECT_NEAR(above(front, 30), 2.0 - climb, 1e-9) << "just behind the edge it faces";
        EXPECT_NEAR(above(30, 25), 2.0 - climb, 1e-9) << "behind that on a side";
        EXPECT_NEAR(above(back, 30), 2.0 - 5.0 * climb, 1e-9) << "nothing comes from behind";
    }
}

/// A hill that lies askew becomes a long one along the wind, whose top is near its front.
TEST(WornRock, HillsBecomeYardangs) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.rock = DuneRock::bed;
    dunes.sand_cover = 0.15;
    dunes.saturation_length = {"hops", 0.0};  // long steps, in which all sand hops
    dunes.deposit_on_rock = 0.1;
    dunes.time_step = {"", 0.004};
    dunes.rock_wear = 0.08;
    dunes.rock_dust = 1.0;
    dunes.rock_repose_angle = 60.0;
    dunes.abrasion_height = {"", 1.0};
    dunes.wind_bend = DuneBend::shear;
    dunes.shear_across = 1.2;
    dunes.winds = {{270.0, 1.0, 1.0, {}, 10.0, 0.0, 0.02}};
    dunes.features = {{FeatureKind::rock, FeatureShape::hill, 32.0, 20.0, 22.0, 12.0, 4.0, 130.0}};
    Dunes model(dunes, thin_sand(112, 40, 0.0, pool));
    const FixedPointGrid& rock = model.bed().rock;
    const Axes first = axes_of_hill(rock);
    EXPECT_LT(first.ratio, 2.0);
    EXPECT_GT(std::abs(first.angle), 30.0);
    for (int step = 0; step < 750; ++step) model.step();
    const Axes then = axes_of_hill(rock);
    EXPECT_GT(then.ratio, 3.0);
    EXPECT_LT(std::abs(then.angle), 10.0);
    EXPECT_LT(first.head, 0.2);
    EXPECT_GT(then.head, 0.3) << "which has a tail";
    EXPECT_GT(*std::ranges::max_element(rock.values()), to_units(2.5)) << "worn at its foot";
}

TEST(WornRock, CrumblesToItsAngleOfRepose) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.rock_wear = 1e-9;
    dunes.features = {{FeatureKind::rock, FeatureShape::block, 24.0, 24.0, 10.0, 10.0, 8.0, 90.0}};
    Dunes model(dunes, thin_sand(48, 48, 0.0, pool));
    EXPECT_EQ(model.bed().rock(24, 24), to_units(8.0));
    while (model.time() < 0.2) model.step();
    const FixedPointGrid& rock = model.bed().rock;
    double steepest = 0.0;
    for (int y = 1; y < 47; ++y) {
        for (int x = 1; x < 47; ++x) {
            const auto fall = [&](std::int64_t a, std::int64_t b) {
                return to_metres(std::max({rock(x, y) - a, rock(x, y) - b, std::int64_t{0}}));
            };
            steepest = std::max(steepest, std::hypot(fall(rock(x - 1, y), rock(x + 1, y)),
                                                     fall(rock(x, y - 1), rock(x, y + 1))));
        }
    }
    EXPECT_NEAR(std::atan(steepest) * 180.0 / std::acos(-1.0), 68.0, 0.5);
    EXPECT_GT(model.bed().worn, 0);
}

TEST(Features, HaveTheirShapesRoundAPeriodicBed) {
    const DuneGround ground{40, 30, 1.0, 2.0, true, true};
    const Grid block = feature_shape(
        {FeatureKind::rock, FeatureShape::block, 1.0, 30.0, 6.0, 8.0, 1.0, 90.0}, ground);
    EXPECT_EQ(block(0, 15), 1.0);
    EXPECT_EQ(block(38, 15), 1.0) << "over the western edge";
    EXPECT_EQ(block(37, 15), 0.0);
    EXPECT_EQ(block(0, 16), 1.0);
    EXPECT_EQ(block(0, 17), 0.0);
    const Grid cone = feature_shape(
        {FeatureKind::rock, FeatureShape::cone, 20.5, 31.0, 20.0, 0.0, 1.0, 0.0}, ground);
    EXPECT_DOUBLE_EQ(cone(20, 15), 1.0);
    EXPECT_NEAR(cone(23, 15), 0.7, 1e-12);
    EXPECT_NEAR(cone(23, 17), 0.5, 1e-12);
    const Grid hill = feature_shape(
        {FeatureKind::rock, FeatureShape::hill, 20.5, 31.0, 20.0, 8.0, 1.0, 0.0}, ground);
    EXPECT_NEAR(hill(20, 17), std::pow(std::cos(0.2 * std::acos(-1.0)), 2), 1e-12) << "along north";
    EXPECT_NEAR(hill(22, 15), 0.5, 1e-12) << "half-way across";
}

TEST(Features, RockDisplacesSandAndHeapsLieOnIt) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.features = {{FeatureKind::rock, FeatureShape::block, 10.0, 10.0, 4.0, 4.0, 3.0, 90.0},
                      {FeatureKind::sand, FeatureShape::block, 12.0, 10.0, 4.0, 4.0, 2.0, 90.0}};
    const Dunes model(dunes, thin_sand(20, 20, 0.5, pool));
    EXPECT_EQ(model.bed().surface(9, 9), to_units(3.0));
    EXPECT_EQ(model.bed().rock(9, 9), to_units(3.0));
    EXPECT_EQ(model.bed().surface(11, 9), to_units(5.0));
    EXPECT_EQ(model.bed().rock(11, 9), to_units(3.0));
    EXPECT_EQ(model.bed().surface(13, 9), to_units(2.5));
    EXPECT_EQ(model.bed().surface(3, 9), to_units(0.5));
}

TEST(Features, SourcesAreFilledUpAgainAndCounted) {
    for (const DuneTransport transport : {DuneTransport::continuous, DuneTransport::slabs}) {
        WorkerPool pool(2);
        DunesParameters parameters;
        parameters.transport = transport;
        parameters.speed_up = DuneSpeedUp::none;
        parameters.edges_x = DuneEdge::open;
        parameters.features = {
            {FeatureKind::source, FeatureShape::cone, 14.0, 12.0, 16.0, 16.0, 4.0, 90.0}};
        Dunes dunes(parameters, thin_sand(48, 24, 0.0, pool));
        const std::int64_t first = sand_less_sources(dunes.bed());
        const FixedPointGrid source = dunes.bed().surface;
        std::int64_t inflow = 0;
        for (int step = 0; step < 40; ++step) {
            dunes.step();
            ASSERT_EQ(sand_less_sources(dunes.bed()), first) << step;
            ASSERT_GT(dunes.bed().inflow, inflow);
            inflow = dunes.bed().inflow;
            for (std::size_t cell = 0; cell < source.size(); ++cell)
                ASSERT_GE(dunes.bed().surface.values()[cell], source.values()[cell]);
        }
    }
}

TEST(WornRock, SlabsRefuseIt) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.transport = DuneTransport::slabs;
    dunes.speed_up = DuneSpeedUp::none;
    dunes.rock_wear = 0.01;
    const auto refusal = [&] {
        return message_of<KeyError>([&] { Dunes(dunes, thin_sand(20, 20, 1.0, pool)); });
    };
    EXPECT_NE(refusal().find("slab transport wears no rock"), std::string::npos);
    dunes.rock_wear = 0.0;
    dunes.abrasion_height = {"", 1.0};
    EXPECT_NE(refusal().find("no rock is worn"), std::string::npos);
    dunes.abrasion_height = {"none", 0.0};
    dunes.rock_dust = 0.5;
    EXPECT_NE(refusal().find("no rock is worn"), std::string::npos);
    dunes.rock_dust = 0.0;
    dunes.wall_drift = 0.5;
    EXPECT_NE(refusal().find("there are no walls"), std::string::npos);
    dunes.wall_angle = {"", 55.0};
    EXPECT_NE(refusal().find("slab transport has no walls"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
