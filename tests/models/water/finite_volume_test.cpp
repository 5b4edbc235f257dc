#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/random.h"
#include "files/terrain/terrain_file.h"
#include "models/water/kernels/finite_volume_vectors.h"
#include "support/finite_volume_run.h"
#include "support/grid_values.h"

namespace fumon {
namespace {

using test::sum;

WaterDomain domain_with(EdgeKind edges_x, EdgeKind edges_y, double slope = 0.0) {
    WaterDomain domain;
    domain.edges_x = edges_x;
    domain.edges_y = edges_y;
    domain.slope = slope;
    return domain;
}

class LakeAtRest : public ::testing::TestWithParam<std::pair<EdgeKind, EdgeKind>> {};

TEST_P(LakeAtRest, StaysWithIslandsAndOnOblongCells) {
    WorkerPool pool(2);
    WaterDomain domain = domain_with(GetParam().first, GetParam().second);
    domain.dx = 0.7;
    domain.dy = 2.3;
    const Grid bed = noise(61, 43, 2.0);
    for (const ShoreCells shores :
         {ShoreCells::whole, ShoreCells::partly_wet, ShoreCells::planes}) {
        GullyParameters parameters = without_friction();
        parameters.shore_cells = shores;
        for (const double level : {0.3, 1.4, 2.5}) {
            FiniteVolumeScheme scheme(parameters, domain, pool);
            Water water = lake(bed, level);
            scheme.convert_to_means(water, bed);
            const Grid before = water.depth;
            for (int step = 0; step < 300; ++step)
                scheme.advance(water, bed, 0.45 * scheme.step_at_courant_one(water), 0.0);
            EXPECT_LE(fastest(water), 1e-13 * std::sqrt(9.8 * level)) << level;
            for (std::size_t i = 0; i < before.size(); ++i)
                ASSERT_NEAR(water.depth.values()[i], before.values()[i], 1e-13)
                    << level << " " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Edges, LakeAtRest,
                         ::testing::Values(std::pair{EdgeKind::periodic, EdgeKind::periodic},
                                           std::pair{EdgeKind::wall, EdgeKind::wall},
                                           std::pair{EdgeKind::periodic, EdgeKind::wall}));

TEST(FiniteVolume, ALakeAwayFromCellsWithoutDataStays) {
    WorkerPool pool(1);
    WaterDomain domain = domain_with(EdgeKind::open, EdgeKind::open);
    domain.nodata = Mask(40, 40);
    domain.nodata(3, 5) = domain.nodata(39, 39) = 1;
    const Grid bed = grid_of(40, 40, [](int x, int y) {
        return std::hypot(x - 20.0, y - 20.0) < 12.0 ? -0.5 + 0.01 * ((7 * x + 13 * y) % 17) : 1.0;
    });
    FiniteVolumeScheme scheme(without_friction(), domain, pool);
    Water water = lake(bed, 0.0);
    const double volume = sum(water.depth);
    run_for(scheme, water, bed, 100.0);
    EXPECT_LE(fastest(water), 1e-13);
    EXPECT_NEAR(sum(water.depth), volume, 1e-11 * volume);
    EXPECT_EQ(scheme.left(), 0.0);
}

TEST(FiniteVolume, AUniformFilmStaysUniform) {
    WorkerPool pool(2);
    for (const auto& [friction, half] :
         {std::pair{FrictionLaw::full, 1.0}, {FrictionLaw::half, 0.5}}) {
        GullyParameters parameters;
        parameters.friction = friction;
        FiniteVolumeScheme scheme(parameters,
                                  domain_with(EdgeKind::periodic, EdgeKind::periodic, 0.04), pool);
        const double speed = std::sqrt(9.8 * 0.01 * 0.04 / (0.01 * half));
        Water water{Grid(50, 40, 0.01), Grid(50, 40), Grid(50, 40, -speed)};
        run_for(scheme, water, Grid(50, 40), 200.0);
        for (std::size_t i = 0; i < water.depth.size(); ++i) {
            ASSERT_EQ(water.depth.values()[i], water.depth.values()[0]);
            ASSERT_EQ(water.velocity_y.values()[i], water.velocity_y.values()[0]);
        }
        EXPECT_NEAR(water.depth(0, 0), 0.01, 1e-15);
        EXPECT_EQ(water.velocity_x(0, 0), 0.0);
        EXPECT_NEAR(water.velocity_y(0, 0), -speed, 1e-12);
    }
}

TEST(FiniteVolume, AFilmThatStartsAtRestReachesItsSpeed) {
    WorkerPool pool(1);
    FiniteVolumeScheme scheme({}, domain_with(EdgeKind::periodic, EdgeKind::periodic, 0.04), pool);
    Water water = still(Grid(4, 4, 0.002));
    run_for(scheme, water, Grid(4, 4), 60.0, 0.45, 0.0, 0.1);
    EXPECT_NEAR(water.velocity_y(2, 2), -std::sqrt(9.8 * 0.002 * 0.04 / 0.01), 1e-9);
}

/// Water thrown over dry rough ground, on cells that are masked here and there.
Water violent(int nx, int ny) {
    Water water = still(grid_of(nx, ny, [&](int x, int y) {
        return std::hypot(x - 0.3 * nx, y - 0.6 * ny) < 9 ? 3.0 : 0.0;
    }));
    for (double& u : water.velocity_x.values()) u = 4.0;
    return water;
}

/// Courant number and friction. Sanitizers take the most violent alone: the others run the same
/// loops.
constexpr auto violent_steps = std::to_array<std::pair<double, double>>({
#ifndef FUMON_SANITIZED
    {0.5, 0.0},
    {0.5, 0.01},
#endif
    {1.0, 0.01},
});

class OverDryRoughGround : public ::testing::TestWithParam<std::pair<ShoreCells, ShoreVelocity>> {};

TEST_P(OverDryRoughGround, NeverNegativeConservedAndNoFasterThanAFront) {
    WorkerPool pool(2);
    for (const EdgeKind edges : {EdgeKind::periodic, EdgeKind::wall, EdgeKind::open}) {
        for (const auto& [courant_number, friction] : violent_steps) {
            WaterDomain domain = domain_with(edges, edges, 0.02);
            domain.nodata = Mask(60, 50);
            for (int x = 25; x < 30; ++x) domain.nodata(x, 20) = domain.nodata(x, 22) = 1;
            GullyParameters parameters;
            parameters.friction_coefficient = friction;
            parameters.shore_cells = GetParam().first;
            parameters.shore_velocity = GetParam().second;
            FiniteVolumeScheme scheme(parameters, domain, pool);
            const Grid bed = noise(60, 50, 1.5);
            Water water = violent(60, 50);
            const double start = sum(water.depth);
            const double front_speed = 4.0 + 2.0 * std::sqrt(9.8 * 4.5);  // from the highest water
            const double rain = 1e-5;
            double fallen = 0.0;
            for (int step = 0; step < 400; ++step) {
                const double dt = std::min(0.5, courant_number * scheme.step_at_courant_one(water));
                scheme.advance(water, bed, dt, rain);
                fallen += dt * rain * (60 * 50 - 10);
                ASSERT_GE(lowest(water.depth), 0.0) << step;
                ASSERT_LT(fastest(water), courant_number < 1.0 ? front_speed : 1e3) << step;
            }
            EXPECT_NEAR((sum(water.depth) + scheme.left()) / (start + fallen), 1.0, 1e-12)
                << static_cast<int>(edges);
            EXPECT_GT(scheme.left(), 0.1 * start);
            EXPECT_EQ(water.depth(26, 20), 0.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(FiniteVolume, OverDryRoughGround,
                         ::testing::Values(std::pair{ShoreCells::whole, ShoreVelocity::sloped},
                                           std::pair{ShoreCells::partly_wet, ShoreVelocity::sloped},
                                           std::pair{ShoreCells::partly_wet, ShoreVelocity::even},
                                           std::pair{ShoreCells::planes, ShoreVelocity::sloped}));

TEST(FiniteVolume, GivesNoMoreWaterThanThereIsInTooLongAStep) {
    WorkerPool pool(1);
    FiniteVolumeScheme scheme(without_friction(), domain_with(EdgeKind::wall, EdgeKind::wall),
                              pool);
    Water water =
        still(grid_of(21, 21, [](int x, int y) { return x == 10 && y == 10 ? 1.0 : 0.0; }));
    for (int step = 0; step < 20; ++step) {
        scheme.advance(water, Grid(21, 21), 4.0 * scheme.step_at_courant_one(water), 0.0);
        ASSERT_GE(lowest(water.depth), 0.0) << step;
        ASSERT_NEAR(sum(water.depth), 1.0, 1e-12) << step;
    }
}

TEST(FiniteVolume, MirrorImagesAndExchangedAxesGiveTheSameFlow) {
    WorkerPool pool(1);
    constexpr int n = 40;
    const Grid bed = noise(n, n, 0.5);
    const auto mirrored = [&](int x, int y) { return bed(n - 1 - x, y); };
    const auto exchanged = [&](int x, int y) { return bed(y, x); };
    const auto depth = [](int x, int y) { return x + 2 * y < 40 ? 1.0 : 0.0; };
    GullyParameters parameters;
    const auto flow = [&](const Grid& ground, Grid start, EdgeKind edges_x, EdgeKind edges_y) {
        FiniteVolumeScheme scheme(parameters, domain_with(edges_x, edges_y), pool);
        Water water = still(start);
        for (int step = 0; step < 200; ++step) scheme.advance(water, ground, 0.05, 1e-4);
        return water;
    };
    for (const ShoreCells shores :
         {ShoreCells::whole, ShoreCells::partly_wet, ShoreCells::planes}) {
        parameters.shore_cells = shores;
        const Water plain = flow(bed, grid_of(n, n, depth), EdgeKind::wall, EdgeKind::open);
        const Water mirror = flow(grid_of(n, n, mirrored),
                                  grid_of(n, n, [&](int x, int y) { return depth(n - 1 - x, y); }),
                                  EdgeKind::wall, EdgeKind::open);
        const Water exchange =
            flow(grid_of(n, n, exchanged), grid_of(n, n, [&](int x, int y) { return depth(y, x); }),
                 EdgeKind::open, EdgeKind::wall);
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                ASSERT_EQ(plain.depth(x, y), mirror.depth(n - 1 - x, y));
                ASSERT_EQ(plain.velocity_x(x, y), -mirror.velocity_x(n - 1 - x, y));
                ASSERT_EQ(plain.velocity_y(x, y), mirror.velocity_y(n - 1 - x, y));
                ASSERT_EQ(plain.depth(x, y), exchange.depth(y, x));
                ASSERT_EQ(plain.velocity_x(x, y), exchange.velocity_y(y, x));
                ASSERT_EQ(plain.velocity_y(x, y), exchange.velocity_x(y, x));
            }
        }
    }
}

TEST(FiniteVolume, TheSameBytesForAnyNumberOfThreads) {
    const Grid bed = noise(1100, 31, 1.5);  // wider than two blocks of columns
    Water one;
    double left = 0.0;
    for (const int threads : {1, 2, 3, 5}) {
        WorkerPool pool(threads);
        FiniteVolumeScheme scheme({}, domain_with(EdgeKind::open, EdgeKind::wall, 0.02), pool);
        Water water = violent(1100, 31);
        for (int step = 0; step < 60; ++step)
            scheme.advance(water, bed, 0.4 * scheme.step_at_courant_one(water), 1e-4);
        if (threads == 1) {
            one = water;
            left = scheme.left();
        }
        EXPECT_EQ(water.depth, one.depth) << threads;
        EXPECT_EQ(water.velocity_x, one.velocity_x) << threads;
        EXPECT_EQ(water.velocity_y, one.velocity_y) << threads;
        EXPECT_EQ(scheme.left(), left) << threads;
    }
}

TEST(FiniteVolume, BlocksOfColumnsJoinWithoutASeam) {
    WorkerPool pool(1);
    GullyParameters parameters;
    const auto flow = [&](int nx, int ny, bool along_x) {
        FiniteVolumeScheme scheme(parameters, domain_with(EdgeKind::periodic, EdgeKind::periodic),
                                  pool);
        const auto height = [&](int x, int y) {
            const int along = along_x ? x : y;
            const int across = along_x ? y : x;
            return 0.1 * ((7 * along + 13 * across + 3 * along * across) % 17);
        };
        const Grid bed = grid_of(nx, ny, height);
        Water water = lake(bed, 0.9);
        for (double& u : (along_x ? water.velocity_x : water.velocity_y).values()) u = 1.0;
        for (int step = 0; step < 50; ++step) scheme.advance(water, bed, 0.05, 0.0);
        return water;
    };
    for (const ShoreCells shores :
         {ShoreCells::whole, ShoreCells::partly_wet, ShoreCells::planes}) {
        parameters.shore_cells = shores;
        const Water wide = flow(1030, 9, true);
        const Water tall = flow(9, 1030, false);
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 1030; ++x) ASSERT_EQ(wide.depth(x, y), tall.depth(y, x)) << x;
        }
    }
}

TEST(FiniteVolume, RainOnARealGullyRunsOffAndIsAccountedFor) {
    const Terrain terrain =
        read_terrain(std::filesystem::path(FUMON_TERRAIN_FOLDER) / "west_bijou_gully.asc", {});
    WorkerPool pool(2);
    WaterDomain domain = domain_with(EdgeKind::open, EdgeKind::open);
    domain.dx = terrain.dx;
    domain.dy = terrain.dy;
    domain.nodata = terrain.nodata;
    const auto inside = static_cast<double>(
        std::count(terrain.nodata.values().begin(), terrain.nodata.values().end(), 0));
    GullyParameters parameters;
    FiniteVolumeScheme scheme(parameters, domain, pool);
    Water water = still(Grid(terrain.heights.nx(), terrain.heights.ny()));
    constexpr double rain = 50.0 / 3600.0 / 1000.0;  // m/s
    double fallen = 0.0;
    for (int step = 0; step < 1500; ++step) {
        const double dt = std::min(1.0, 0.45 * scheme.step_at_courant_one(water));
        scheme.advance(water, terrain.heights, dt, rain);
        fallen += dt * rain * inside * terrain.dx * terrain.dy;
        ASSERT_GE(lowest(water.depth), 0.0) << step;
        ASSERT_LT(fastest(water), 4.0) << step;  // no jets: the steady run-off has 2.3 m/s
    }
    const double there = sum(water.depth) * terrain.dx * terrain.dy;
    EXPECT_NEAR((there + scheme.left()) / fallen, 1.0, 1e-12);
    EXPECT_GT(scheme.left(), 0.05 * fallen);
}

TEST(FiniteVolume, FindsTheSameRatesOnCellsOfAnyWidth) {
    constexpr int cells = 37;
    std::array<double, cells> depth{};
    std::array<double, cells> u{};
    std::array<double, cells> v{};
    RandomStream random(1, 0, 0, Purpose::initial_bed);
    for (const double dx : {0.25, 1.0, 3.0, 4.0, 0.7}) {
        for (const double dy : {0.5, 2.0, 0.3}) {
            double largest = 0.0;
            for (std::size_t x = 0; x < cells; ++x) {
                depth[x] = random.uniform();
                u[x] = random.uniform() - 0.5;
                v[x] = random.uniform() - 0.5;
                const double c = std::sqrt(9.8 * depth[x]);
                largest =
                    std::max(largest, (std::fabs(u[x]) + c) / dx + (std::fabs(v[x]) + c) / dy);
            }
            EXPECT_EQ(finite_volume::fastest(depth.data(), u.data(), v.data(), 9.8, dx, dy, cells),
                      largest)
                << dx << " x " << dy;
        }
    }
}

}  // namespace
}  // namespace fumon
