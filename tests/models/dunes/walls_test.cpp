#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/worker_pool.h"
#include "models/dunes/dunes.h"

namespace fumon::test {
namespace {

ModelSetup sand_before_walls(int nx, int ny, double thickness, WorkerPool& pool) {
    return {Grid(nx, ny, thickness), {}, {1.0, 1.0, 1.0, true}, 7, pool};
}

TEST(Walls, TurnTheWindBackAtTheirFoot) {
    for (const auto& [from, dx, dy] : {std::tuple{270.0, -1, 0}, std::tuple{90.0, 1, 0},
                                       std::tuple{180.0, 0, -1}, std::tuple{0.0, 0, 1}}) {
        SCOPED_TRACE(from);
        const DuneGround ground{60, 60, 1.0, 1.0, true, true};
        FixedPointGrid surface(60, 60);
        for (int y = 25; y < 35; ++y) {
            for (int x = 25; x < 35; ++x) surface(x, y) = to_units(10.0);
        }
        const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
        WorkerPool pool(2);
        WindwardWalls walls(ground, std::tan(55.0 * std::acos(-1.0) / 180.0), 0.8, pool);
        walls.find(surface, turns.at(0));
        const auto at = [&, dx = dx, dy = dy](int cells) {
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
    Dunes model(dunes, sand_before_walls(96, 48, 0.3, pool));
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

TEST(Walls, WindsAlongThemBlowTowardTheirEnds) {
    for (const double from : {270.0, 180.0}) {
        SCOPED_TRACE(from);
        const DuneGround ground{60, 60, 1.0, 1.0, true, true};
        const bool along_x = from == 270.0;
        for (const int width : {20, 60}) {
            FixedPointGrid surface(60, 60);
            for (int i = 25; i < 35; ++i) {
                for (int j = 0; j < width; ++j) {
                    const int across = (50 + j) % 60;  // over an edge
                    surface(along_x ? i : across, along_x ? across : i) = to_units(10.0);
                }
            }
            const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
            WorkerPool pool(2);
            WindwardWalls walls(ground, std::tan(55.0 * std::acos(-1.0) / 180.0), 0.8, pool);
            walls.find(surface, turns.at(0));
            const auto aside = [&](int cells, int across) {
                const double v =
                    walls.aside()(along_x ? 24 - cells : across, along_x ? across : 24 - cells);
                return along_x ? v : -v;  // toward larger numbers
            };
            const bool ends = width == 20;
            EXPECT_NEAR(aside(0, 50), ends ? -0.8 : 0.0, 1e-12);
            EXPECT_NEAR(aside(3, 9), ends ? 0.8 : 0.0, 1e-12);
            EXPECT_NEAR(aside(7, 9), ends ? 0.4 : 0.0, 1e-12) << "half-way to its height";
            EXPECT_EQ(aside(10, 9), 0.0);
            EXPECT_EQ(aside(0, 11), 0.0) << "beside it, or endless";
        }
    }
}

/// Of the sand that a wind brings to a wall the foot stays bare, however long it blows.
TEST(Walls, TheDriftAlongThemKeepsACorridorBare) {
    const auto at_the_foot = [](double drift) {
        WorkerPool pool(2);
        DunesParameters dunes;
        dunes.wall_angle = {"", 55.0};
        dunes.wall_drift = drift;
        dunes.features = {
            {FeatureKind::rock, FeatureShape::block, 70.0, 32.0, 16.0, 32.0, 10.0, 90.0}};
        Dunes model(dunes, sand_before_walls(96, 64, 0.4, pool));
        for (int step = 0; step < 700; ++step) model.step();
        const auto sand = [&](int x) {
            return to_metres(model.bed().surface(x, 32) - model.bed().rock(x, 32));
        };
        double highest = 0.0;
        for (int x = 42; x < 58; ++x) highest = std::max(highest, sand(x));
        EXPECT_GT(highest, 1.0);
        return std::max({sand(61), sand(60), sand(59)});
    };
    EXPECT_LT(at_the_foot(1.0), 0.02);
    EXPECT_GT(at_the_foot(0.0), 0.02);
}

}  // namespace
}  // namespace fumon::test
