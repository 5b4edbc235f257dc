#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/dunes/ground_features.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

ModelSetup thin_sand(int nx, int ny, double thickness, WorkerPool& pool) {
    return {Grid(nx, ny, thickness), {}, {1.0, 1.0, 1.0, true}, 7, pool};
}

std::int64_t units_of(const WholeGrid& grid) {
    return std::accumulate(grid.values().begin(), grid.values().end(), std::int64_t{0});
}

std::int64_t sand_less_sources(const DuneBed& bed) {
    return units_of(bed.surface) - units_of(bed.rock) + units_of(bed.moving) + bed.outflow -
           bed.inflow - bed.worn;
}

TEST(WornRock, SandOutflowInflowAndWornRockBalanceExactly) {
    for (const bool open : {false, true}) {
        std::vector<Sha256> hashes;
        for (const int threads : {1, 2, 5}) {
            WorkerPool pool(threads);
            DunesParameters dunes;
            dunes.rock_wear = 0.02;
            dunes.edges_x = open ? DuneEdge::open : DuneEdge::periodic;
            dunes.influx = 0.5;
            dunes.winds = {{270.0, 1.0, 0.01}, {20.0, 1.3, 0.005}};
            dunes.wall_angle = {"", 55.0};
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
    RockWear rock(ground, 0.01, std::tan(68.0 * std::acos(-1.0) / 180.0), pool);
    DuneBed bed{WholeGrid(20, 10), WholeGrid(20, 10), WholeGrid(20, 10)};
    bed.surface(7, 4) = to_units(0.025);
    bed.surface(9, 4) = to_units(0.06);
    const WindTurns turns({{270.0, 1.0, 1.0}}, [](double) { return 1.0; });
    Grid cover(20, 10);
    cover(3, 4) = 0.75;
    rock.wear(bed, turns.at(0), WholeGrid(20, 10, to_units(0.2)), &cover);
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
    RockWear rock(ground, 0.01, std::tan(68.0 * std::acos(-1.0) / 180.0), pool);
    DuneBed bed{WholeGrid(40, 10), WholeGrid(40, 10), WholeGrid(40, 10)};
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 40; ++x) bed.rock(x, y) = to_units(0.4 * (x < 20 ? x : 40 - x));
    }
    bed.surface = bed.rock;
    const WholeGrid first = bed.rock;
    const WindTurns turns({{270.0, 1.0, 1.0}}, [](double) { return 1.0; });
    rock.wear(bed, turns.at(0), WholeGrid(40, 10, to_units(0.1)), nullptr);
    EXPECT_NEAR(to_metres(first(10, 5) - bed.rock(10, 5)), 0.003, 1e-9) << "1 + .4 / .2";
    EXPECT_EQ(bed.rock(30, 5), first(30, 5)) << "in the lee";
}

TEST(WornRock, CrumblesToItsAngleOfRepose) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.rock_wear = 1e-9;
    dunes.features = {{FeatureKind::rock, FeatureShape::block, 24.0, 24.0, 10.0, 10.0, 8.0, 90.0}};
    Dunes model(dunes, thin_sand(48, 48, 0.0, pool));
    EXPECT_EQ(model.bed().rock(24, 24), to_units(8.0));
    for (int step = 0; step < 400; ++step) model.step();
    const WholeGrid& rock = model.bed().rock;
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
        const WholeGrid source = dunes.bed().surface;
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

TEST(Walls, TurnTheWindBackAtTheirFoot) {
    for (const auto& [from, dx, dy] : {std::tuple{270.0, -1, 0}, std::tuple{90.0, 1, 0},
                                       std::tuple{180.0, 0, -1}, std::tuple{0.0, 0, 1}}) {
        SCOPED_TRACE(from);
        const DuneGround ground{60, 60, 1.0, 1.0, true, true};
        WholeGrid surface(60, 60);
        for (int y = 25; y < 35; ++y) {
            for (int x = 25; x < 35; ++x) surface(x, y) = to_units(10.0);
        }
        const WindTurns turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
        WorkerPool pool(2);
        WindwardWalls walls(ground, std::tan(55.0 * std::acos(-1.0) / 180.0), pool);
        walls.find(surface, turns.at(0));
        const auto at = [&](int cells) {
            const int x = dx == 0 ? 30 : dx < 0 ? 24 - cells : 35 + cells;
            const int y = dy == 0 ? 30 : dy < 0 ? 24 - cells : 35 + cells;
            return walls.wind()(x, y);
        };
        EXPECT_DOUBLE_EQ(at(0), -0.5);
        EXPECT_DOUBLE_EQ(at(2), -0.25);
        EXPECT_NEAR(at(4), 0.0, 1e-12) << "at .4 of its height";
        EXPECT_NEAR(at(12), 0.5, 1e-12);
        EXPECT_DOUBLE_EQ(at(20), 1.0);
        EXPECT_DOUBLE_EQ(walls.wind()(30, 30), 1.0) << "on top";
    }
}

/// Sand that drifts up to a wall stays before it, with bare ground at its foot; up to a hill of the
/// same height it does not.
TEST(Walls, AnEchoDuneStandsClearOfTheWall) {
    WorkerPool pool(2);
    DunesParameters dunes;
    dunes.wall_angle = {"", 55.0};
    dunes.features = {{FeatureKind::rock, FeatureShape::block, 70.0, 24.0, 16.0, 48.0, 10.0, 90.0}};
    Dunes model(dunes, thin_sand(96, 48, 0.3, pool));
    for (int step = 0; step < 700; ++step) model.step();
    int crest = 0;
    for (int x = 30; x < 62; ++x) {
        if (model.bed().surface(x, 24) > model.bed().surface(crest, 24)) crest = x;
    }
    const double distance = 61.5 - crest;
    EXPECT_GT(to_metres(model.bed().surface(crest, 24)), 1.5);
    EXPECT_GT(distance, 4.0);
    EXPECT_LT(distance, 12.0);
    EXPECT_LT(to_metres(model.bed().surface(61, 24)), 0.6) << "at the foot";
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
    EXPECT_NE(refusal().find("slabs wear no rock"), std::string::npos);
    dunes.rock_wear = 0.0;
    dunes.wall_angle = {"", 55.0};
    EXPECT_NE(refusal().find("slabs meet no walls"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
