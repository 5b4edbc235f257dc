// Wind shadows behind walls, round a periodic bed, and over lines cut apart anywhere.

#include "models/dunes/wind/wind_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/worker_pool.h"
#include "support/uneven_bed.h"

namespace fumon::test {
namespace {

TEST(WindShadow, LiesBehindAWall) {
    WorkerPool pool(2);
    for (const auto& [from, behind_x, behind_y] :
         {std::tuple{270.0, 1, 0}, std::tuple{90.0, -1, 0}, std::tuple{180.0, 0, 1},
          std::tuple{0.0, 0, -1}, std::tuple{225.0, 1, 1}}) {
        DuneGround ground{64, 64, 1.0, 1.0, true, true};
        FixedPointGrid surface(64, 64);
        for (int y = 28; y < 36; ++y) {
            for (int x = 28; x < 36; ++x) surface(x, y) = to_units(3.0);
        }
        const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
        WindShadow shadow(ground, pool);
        const double full = std::tan(std::acos(-1.0) / 12.0);
        shadow.cast(surface, turns.at(0), {0.5 * full, full}, WindShadow::Find::shade_and_envelope);
        const double step = std::hypot(behind_x, behind_y);
        const auto at = [&, behind_x = behind_x, behind_y = behind_y](int cells, const Grid& grid) {
            const int side = behind_x + behind_y > 0 ? 35 : 28;
            return grid(behind_x != 0 ? side + cells * behind_x : 32,
                        behind_y != 0 ? side + cells * behind_y : 32);
        };
        SCOPED_TRACE(from);
        EXPECT_EQ(at(0, shadow.shade()), 0.0) << "on top";
        for (int cells = 1; cells < 25; ++cells) {
            const double distance = cells * step;
            const double full_line = 3.0 - full * distance;
            const double soft_line = 3.0 - 0.5 * full * distance;
            const double expected =
                full_line >= 0.0 ? 1.0 : std::max(0.0, soft_line / (0.5 * full * distance));
            EXPECT_NEAR(at(cells, shadow.shade()), expected, 1e-6) << cells;
            EXPECT_NEAR(at(cells, shadow.envelope()), std::max(0.0, full_line), 1e-9) << cells;
        }
        EXPECT_EQ(at(-12, shadow.shade()), 0.0) << "before it";
    }
}

TEST(WindShadow, GoesRoundAPeriodicBed) {
    WorkerPool pool(1);
    DuneGround ground{50, 10, 1.0, 1.0, true, true};
    FixedPointGrid surface(50, 10);
    for (int y = 0; y < 10; ++y) surface(45, y) = to_units(4.0);
    const WindSchedule turns({{270.0, 1.0, 1.0}}, [](double) { return 1.0; });
    WindShadow shadow(ground, pool);
    shadow.cast(surface, turns.at(0), {0.25, 0.25}, WindShadow::Find::shade_and_envelope);
    EXPECT_EQ(shadow.shade()(49, 5), 1.0);
    EXPECT_EQ(shadow.shade()(5, 5), 1.0) << "ten cells on";
    EXPECT_EQ(shadow.shade()(15, 5), 0.0);
    ground.periodic_x = false;
    WindShadow open(ground, pool);
    open.cast(surface, turns.at(0), {0.25, 0.25}, WindShadow::Find::shade_and_envelope);
    EXPECT_EQ(open.shade()(5, 5), 0.0);
}

/// Lines are followed so many at a time: where they are cut apart must not be seen.
TEST(WindShadow, IsTheSameWhereverLinesAreCutApart) {
    constexpr int nx = 150;
    constexpr int ny = 134;
    constexpr int moved = 29;
    FixedPointGrid surface(nx, ny);
    FixedPointGrid beside(nx, ny);
    const Grid heights = uneven_bed(nx, ny, 6.0);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            surface(x, y) = to_units(heights(x, y));
            beside(x, (y + moved) % ny) = surface(x, y);
        }
    }
    for (const bool periodic : {true, false}) {
        const DuneGround ground{nx, ny, 1.0, 1.0, periodic, periodic};
        for (const double from : {270.0, 90.0, 258.0, 301.0, 180.0, 10.0, 225.0}) {
            SCOPED_TRACE(from);
            const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
            const auto shade_of = [&](const FixedPointGrid& bed, int threads) {
                WorkerPool pool(threads);
                WindShadow shadow(ground, pool);
                shadow.cast(bed, turns.at(0), {0.2, 0.3}, WindShadow::Find::shade_and_envelope);
                return std::pair(shadow.shade(), shadow.envelope());
            };
            const auto one = shade_of(surface, 1);
            EXPECT_TRUE(one == shade_of(surface, 3));
            const bool along_x = from > 225.0 || from == 90.0;
            if (!periodic || !along_x) continue;
            const Grid other = shade_of(beside, 1).first;
            for (int y = 0; y < ny; ++y) {
                EXPECT_TRUE(std::ranges::equal(other.row((y + moved) % ny), one.first.row(y))) << y;
            }
        }
    }
}

}  // namespace
}  // namespace fumon::test
