#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dam_break.h"
#include "support/finite_volume_run.h"

namespace fumon {
namespace {

constexpr double gravity = 9.8;

/// Mean |h − exact| of a dam break on `cells` cells over 20 m after 1 s.
double dam_break_error(int cells, double left, double right) {
    WorkerPool pool(1);
    WaterDomain domain;
    domain.dx = 20.0 / cells;
    domain.dy = 1.0;
    domain.edges_x = EdgeKind::wall;
    FiniteVolumeScheme scheme(without_friction(), domain, pool);
    Water water =
        still(grid_of(cells, 1, [&](int x, int /*y*/) { return 2 * x < cells ? left : right; }));
    run_for(scheme, water, Grid(cells, 1), 1.0);
    double error = 0.0;
    for (int x = 0; x < cells; ++x) {
        const double place = (x + 0.5) * domain.dx - 10.0;
        error += std::fabs(water.depth(x, 0) - dam_break(left, right, gravity, place, 1.0).depth);
    }
    return error / cells;
}

TEST(FiniteVolumeOrder, DamBreakOnADryBed) {
    const double coarse = dam_break_error(100, 1.0, 0.0);
    const double middle = dam_break_error(200, 1.0, 0.0);
    const double fine = dam_break_error(400, 1.0, 0.0);
    EXPECT_LT(coarse, 0.0035);  // measured: .00316, .00156, .00078
    EXPECT_GT(std::log2(coarse / middle), 0.9);
    EXPECT_GT(std::log2(middle / fine), 0.9);
}

TEST(FiniteVolumeOrder, DamBreakOnAWetBed) {
    const double coarse = dam_break_error(100, 1.0, 0.1);
    const double middle = dam_break_error(200, 1.0, 0.1);
    const double fine = dam_break_error(400, 1.0, 0.1);
    EXPECT_LT(coarse, 0.004);  // measured: .00369, .00170, .00086
    EXPECT_GT(std::log2(coarse / middle), 0.9);
    EXPECT_GT(std::log2(middle / fine), 0.9);
}

/// A wave that runs toward +x into still water of 1 m, u = 2 (c − c0): every depth keeps its speed
/// u + c (Stoker 1957), so the depth at x came from x0 with x = x0 + (3 c(x0) − 2 c0) t.
double simple_wave_depth(double x, double t, double length, double height) {
    const double c0 = std::sqrt(gravity);
    const auto depth = [&](double x0) {
        return 1.0 + height * std::sin(2.0 * 3.14159265358979323846 * x0 / length);
    };
    double low = x - 20.0 * c0 * t - 1.0;
    double high = x;
    for (int halving = 0; halving < 100; ++halving) {
        const double x0 = 0.5 * (low + high);
        (x0 + (3.0 * std::sqrt(gravity * depth(x0)) - 2.0 * c0) * t < x ? low : high) = x0;
    }
    return depth(0.5 * (low + high));
}

double simple_wave_error(int cells) {
    constexpr double length = 10.0;
    constexpr double height = 0.05;
    constexpr double duration = 2.0;
    WorkerPool pool(1);
    WaterDomain domain;
    domain.dx = length / cells;
    FiniteVolumeScheme scheme(without_friction(), domain, pool);
    const auto mean_depth = [&](int x, double t) {  // by Simpson's rule over the cell
        const double left = x * domain.dx;
        return (simple_wave_depth(left, t, length, height) +
                4.0 * simple_wave_depth(left + 0.5 * domain.dx, t, length, height) +
                simple_wave_depth(left + domain.dx, t, length, height)) /
               6.0;
    };
    Water water = still(Grid(cells, 1));
    for (int x = 0; x < cells; ++x) {
        water.depth(x, 0) = mean_depth(x, 0.0);
        water.velocity_x(x, 0) =
            2.0 * (std::sqrt(gravity * water.depth(x, 0)) - std::sqrt(gravity));
    }
    run_for(scheme, water, Grid(cells, 1), duration, 0.4);
    double error = 0.0;
    for (int x = 0; x < cells; ++x) error += std::fabs(water.depth(x, 0) - mean_depth(x, duration));
    return error / cells;
}

TEST(FiniteVolumeOrder, ASmoothWaveIsOfSecondOrder) {
    const double coarse = simple_wave_error(50);
    const double middle = simple_wave_error(100);
    const double fine = simple_wave_error(200);
    EXPECT_LT(coarse, 0.0004);  // measured: .000365, .0000994, .0000259
    EXPECT_GT(std::log2(coarse / middle), 1.8);
    EXPECT_GT(std::log2(middle / fine), 1.8);
}

}  // namespace
}  // namespace fumon
