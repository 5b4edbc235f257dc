#include "models/avalanche/slope_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/shared/fixed_point_lengths.h"

namespace fumon::test {
namespace {

constexpr int plenty = 1'000'000;

std::int64_t total(const FixedPointGrid& grid) {
    return std::accumulate(grid.values().begin(), grid.values().end(), std::int64_t{0});
}

FixedPointGrid rough(int nx, int ny, double height) {
    FixedPointGrid grid(nx, ny);
    RandomStream stream(5, 0, 0, Purpose::initial_bed);
    for (std::int64_t& cell : grid.values()) cell = to_units(height * stream.uniform());
    return grid;
}

/// How far from round a cone is: (largest − smallest radius) / mean, over all directions, of the
/// circle at a third of its height.
double out_of_round(const FixedPointGrid& surface, int centre, double& mean_radius) {
    const double level = to_metres(surface(centre, centre)) / 3.0;
    const auto height = [&](double x, double y) {
        const int i = static_cast<int>(x);
        const int j = static_cast<int>(y);
        const double u = x - i;
        const double v = y - j;
        return (1 - v) * ((1 - u) * to_metres(surface(i, j)) + u * to_metres(surface(i + 1, j))) +
               v * ((1 - u) * to_metres(surface(i, j + 1)) + u * to_metres(surface(i + 1, j + 1)));
    };
    double least = 1e9;
    double most = 0.0;
    double sum = 0.0;
    constexpr int directions = 720;
    for (int k = 0; k < directions; ++k) {
        const double angle = 2.0 * std::acos(-1.0) * k / directions;
        double radius = 0.0;
        while (height(centre + radius * std::cos(angle), centre + radius * std::sin(angle)) > level)
            radius += 0.02;
        least = std::min(least, radius);
        most = std::max(most, radius);
        sum += radius;
    }
    mean_radius = sum / directions;
    return (most - least) / mean_radius;
}

/// Sand dropped on a single cell, bit by bit.
FixedPointGrid dropped_cone(int side, double volume, int portions, WorkerPool& pool) {
    FixedPointGrid surface(side, side);
    const FixedPointGrid floor(side, side);
    SlopeRelaxation slopes({side, side, 1.0, 1.0, true, true}, {}, pool);
    for (int portion = 0; portion < portions; ++portion) {
        surface(side / 2, side / 2) += to_units(volume / portions);
        EXPECT_TRUE(slopes.relax(surface, floor, plenty).at_rest);
    }
    return surface;
}

TEST(SlopeRelaxation, ADroppedConeIsRoundAndAtItsAngle) {
    WorkerPool pool(2);
    const FixedPointGrid cone = dropped_cone(120, 42'000.0, 40, pool);
    EXPECT_EQ(total(cone), 40 * to_units(42'000.0 / 40));
    double radius = 0.0;
    EXPECT_LT(out_of_round(cone, 60, radius), 0.015);
    const double of_base = radius * 1.5;
    EXPECT_GT(of_base, 35.0);
    EXPECT_LT(of_base, 55.0) << "the cone is whole";
    const double slope = std::atan(to_metres(cone(60, 60)) * 2.0 / 3.0 / radius);
    EXPECT_NEAR(slope * degrees_per_radian, 33.0, 1.0);
}

TEST(SlopeRelaxation, NoSlopeExceedsTheAngleAndSandIsConserved) {
    WorkerPool pool(2);
    for (const ReposeAngles angles : {ReposeAngles{33.0, 33.0}, ReposeAngles{34.0, 31.0}}) {
        for (const bool periodic : {true, false}) {
            FixedPointGrid surface = rough(67, 41, 20.0);
            const FixedPointGrid floor(67, 41);
            const std::int64_t before = total(surface);
            SlopeRelaxation slopes({67, 41, 1.0, 1.5, periodic, periodic}, angles, pool);
            EXPECT_GT(slopes.steepest(surface, floor), 60.0);
            const auto outcome = slopes.relax(surface, floor, plenty);
            EXPECT_TRUE(outcome.at_rest);
            EXPECT_GT(outcome.passes, 10);
            EXPECT_LE(slopes.steepest(surface, floor), angles.resting + 0.5);
            EXPECT_GT(slopes.steepest(surface, floor), angles.moving - 1.0);
            EXPECT_EQ(total(surface), before);
            const FixedPointGrid at_rest = surface;
            EXPECT_EQ(slopes.relax(surface, floor, plenty).passes, 0);
            EXPECT_EQ(surface, at_rest);
        }
    }
}

TEST(SlopeRelaxation, AnyNumberOfThreadsGivesTheSameUnits) {
    std::vector<FixedPointGrid> results;
    for (const int threads : {1, 2, 3, 7}) {
        WorkerPool pool(threads);
        FixedPointGrid surface = rough(130, 90, 12.0);
        const FixedPointGrid floor(130, 90);
        SlopeRelaxation slopes({130, 90, 1.0, 1.0, true, false}, {}, pool);
        slopes.relax(surface, floor, plenty);
        results.push_back(surface);
    }
    for (const FixedPointGrid& result : results) EXPECT_EQ(result, results.front());
}

/// The passes as they are defined, one after the other, cell after cell; returns how many moved
/// anything.
int plain_passes(FixedPointGrid& surface, const FixedPointGrid& floor,
                 const AvalancheGround& ground, const ReposeAngles& angles, int most) {
    const auto tangent = [](double degrees) {
        return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
    };
    const int nx = ground.nx;
    const int ny = ground.ny;
    const auto beside = [](int at, int step, int count, bool periodic) {
        const int to = at + step;
        return to >= 0 && to < count ? to : periodic ? (to + count) % count : at;
    };
    const double rest = tangent(angles.moving);
    FixedPointGrid before = surface;
    FixedPointGrid slid(nx, ny, 1);
    for (int pass = 0; pass < most; ++pass) {
        const double start =
            rest * (tangent((pass == 0 ? angles.resting : angles.moving) + 0.4) / rest);
        FixedPointGrid slides(nx, ny);
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const std::array xs{beside(x, -1, nx, ground.periodic_x),
                                    beside(x, 1, nx, ground.periodic_x)};
                const std::array ys{beside(y, -1, ny, ground.periodic_y),
                                    beside(y, 1, ny, ground.periodic_y)};
                if (slid(x, y) + slid(xs[0], y) + slid(xs[1], y) + slid(x, ys[0]) +
                        slid(x, ys[1]) ==
                    0)
                    continue;
                const int to_x = before(xs[1], y) > before(xs[0], y) ? xs[0] : xs[1];
                const int to_y = before(x, ys[1]) > before(x, ys[0]) ? ys[0] : ys[1];
                const auto fall_to = [&](std::int64_t there) {
                    return static_cast<double>(std::max<std::int64_t>(before(x, y) - there, 0));
                };
                const double fall_x = fall_to(before(to_x, y));
                const double fall_y = fall_to(before(x, to_y));
                const double a = fall_x * (metres_per_unit / ground.dx);
                const double b = fall_y * (metres_per_unit / ground.dy);
                const double square = a * a + b * b;
                const std::int64_t loose = before(x, y) - floor(x, y);
                if (!(square > start * start) || loose <= 0) continue;
                const double share = 0.25 * (1.0 - rest / std::sqrt(square));
                auto along = static_cast<std::int64_t>(fall_x * share);
                auto across = static_cast<std::int64_t>(fall_y * share);
                if (along + across > loose) {
                    along = static_cast<std::int64_t>(static_cast<double>(loose) *
                                                      (fall_x / (fall_x + fall_y)));
                    across = loose - along;
                }
                slides(x, y) = along + across;
                surface(x, y) -= along + across;
                surface(to_x, y) += along;
                surface(x, to_y) += across;
            }
        }
        if (total(slides) == 0) return pass;
        slid = slides;
        before = surface;
    }
    return most;
}

TEST(SlopeRelaxation, ManyPassesTogetherAreThoseOfOneAfterTheOther) {
    const ReposeAngles angles{34.0, 31.0};
    constexpr int nx = 75;
    for (const int ny : {3, 20, 75}) {
        FixedPointGrid floor = rough(nx, ny, 3.0);
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < 64; ++x) floor(x, y) = to_units(1.0);
        }
        const FixedPointGrid sand = rough(nx, ny, 9.0);
        for (const bool periodic : {true, false}) {
            const AvalancheGround ground{nx, ny, 1.0, 1.5, periodic, periodic};
            for (const int threads : {1, 3}) {
                SCOPED_TRACE(testing::Message() << ny << " rows, periodic " << periodic << ", "
                                                << threads << " threads");
                WorkerPool pool(threads);
                FloorRange range;
                range.find(floor, pool);
                SlopeRelaxation slopes(ground, angles, pool);
                FixedPointGrid surface = floor;
                FixedPointGrid plain = floor;
                const auto fall = [&](FixedPointGrid& on, int y) {
                    for (int x = 0; x < nx; ++x) on(x, y) += sand((x * 7 + y) % nx, y) / 8;
                };
                for (const int most : {1, 1, 1, 7, 1, 1, 200}) {
                    for (int y = 0; y < ny; ++y) fall(plain, y);
                    const int passes = plain_passes(plain, floor, ground, angles, most);
                    const auto outcome = slopes.relax(surface, {floor, &range}, most,
                                                      SlopeRelaxation::RestCheck::skipped,
                                                      [&](int y) { fall(surface, y); });
                    EXPECT_EQ(outcome.passes, passes);
                    ASSERT_EQ(surface, plain) << "after " << most << " passes";
                }
            }
        }
    }
}

TEST(SlopeRelaxation, RockStaysSteepAndSandFillsItsFoot) {
    WorkerPool pool(1);
    FixedPointGrid floor(60, 40);
    for (int y = 0; y < 40; ++y) {
        for (int x = 20; x < 40; ++x) floor(x, y) = to_units(10.0);
    }
    FixedPointGrid surface = floor;
    for (std::int64_t& height : surface.values()) height += to_units(0.5);
    const std::int64_t sand = total(surface) - total(floor);
    SlopeRelaxation slopes({60, 40, 1.0, 1.0, true, true}, {}, pool);
    EXPECT_TRUE(slopes.relax(surface, floor, plenty).at_rest);
    EXPECT_EQ(total(surface) - total(floor), sand);
    for (std::size_t cell = 0; cell < surface.size(); ++cell)
        ASSERT_GE(surface.values()[cell], floor.values()[cell]);
    EXPECT_EQ(surface(20, 20), floor(20, 20)) << "bare at the edge";
    EXPECT_GT(surface(19, 20), to_units(0.6)) << "at its foot";
    EXPECT_LE(slopes.steepest(surface, floor), 33.5);
}

TEST(SlopeRelaxation, AnglesMayDifferFromCellToCell) {
    WorkerPool pool(2);
    FixedPointGrid surface = rough(80, 40, 15.0);
    const FixedPointGrid floor(80, 40);
    SlopeRelaxation slopes({80, 40, 1.0, 1.0, false, true}, {}, pool);
    Grid angles(80, 40, 20.0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 40; x < 80; ++x) angles(x, y) = 40.0;
    }
    slopes.set_moving_angles(angles);
    EXPECT_TRUE(slopes.relax(surface, floor, plenty).at_rest);
    EXPECT_GT(slopes.steepest(surface, floor), 38.0);
    EXPECT_LE(slopes.steepest(surface, floor), 40.5);
    for (int y = 0; y < 40; ++y) {
        for (int x = 1; x < 39; ++x) {
            const double fall = to_metres(std::abs(surface(x, y) - surface(x + 1, y)));
            ASSERT_LE(fall, std::tan(20.5 * degree)) << x << ", " << y;
        }
    }
}

TEST(SlopeRelaxation, TheCapOnPassesIsReported) {
    WorkerPool pool(1);
    FixedPointGrid surface(30, 30);
    const FixedPointGrid floor(30, 30);
    surface(15, 15) = to_units(50.0);
    SlopeRelaxation slopes({30, 30, 1.0, 1.0, true, true}, {}, pool);
    const auto outcome = slopes.relax(surface, floor, 5);
    EXPECT_FALSE(outcome.at_rest);
    EXPECT_EQ(outcome.passes, 5);
    EXPECT_EQ(total(surface), to_units(50.0));
}

TEST(SlopeRelaxation, OneCellAfterTheOtherComesToTheSameAngle) {
    WorkerPool pool(1);
    FixedPointGrid surface(80, 80);
    const FixedPointGrid floor(80, 80);
    SlopeRelaxation slopes({80, 80, 1.0, 1.0, true, true}, {}, pool);
    const std::vector<std::size_t> centre{40 * 80 + 40};
    for (int portion = 0; portion < 400; ++portion) {
        surface(40, 40) += to_units(10.0);
        ASSERT_TRUE(slopes.relax_near(surface, floor, centre, plenty));
    }
    EXPECT_EQ(total(surface), 400 * to_units(10.0));
    EXPECT_LE(slopes.steepest(surface, floor), 33.5);
    double radius = 0.0;
    EXPECT_LT(out_of_round(surface, 40, radius), 0.06);
    surface(40, 40) += to_units(30.0);
    EXPECT_FALSE(slopes.relax_near(surface, floor, centre, 3));
    EXPECT_TRUE(slopes.relax_near(surface, floor, centre, plenty)) << "and it can go on";
    EXPECT_EQ(slopes.relax(surface, floor, plenty).passes, 0);
}

}  // namespace
}  // namespace fumon::test
