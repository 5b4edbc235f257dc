#include "models/water/depth_flux.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/gully_run.h"

namespace fumon::test {
namespace {

PaddedGrid padded(const Grid& grid) {
    PaddedGrid out(grid.nx(), grid.ny());
    for (int y = 0; y < grid.ny(); ++y) {
        std::copy(grid.row(y).begin(), grid.row(y).end(), out.row(y));
        out.wrap(y);
    }
    return out;
}

Grid carried(const Grid& depth, const Grid& u, const Grid& v, double dt) {
    DepthFlux flux(depth.nx(), depth.ny(), 1.0, 1.0);
    Grid after(depth.nx(), depth.ny());
    const PaddedGrid before = padded(depth);
    flux.begin(dt, 0.0);
    flux.carry(before, padded(u), padded(v), 0, depth.ny(), after);
    flux.finish(before, padded(u), padded(v), after);
    return after;
}

double sum_of(const Grid& grid) {
    double total = 0.0;
    for (const double value : grid.values()) total += value;
    return total;
}

TEST(DepthFlux, FlowThatTearsWaterApartTakesNoMoreThanThereIs) {
    const int side = 17;
    const Grid depth = noise(side, side, 1.0);
    Grid u = noise(side, side, 1.6, 2);
    Grid v = noise(side, side, 1.6, 3);
    for (double& speed : u.values()) speed -= 0.8;
    for (double& speed : v.values()) speed -= 0.8;
    const Grid after = carried(depth, u, v, 0.9);
    EXPECT_GE(*std::min_element(after.values().begin(), after.values().end()), 0.0);
    EXPECT_NEAR(sum_of(after), sum_of(depth), 1e-12 * sum_of(depth));
}

TEST(DepthFlux, AWaveComesRoundWithLittleLoss) {
    const int nx = 64;
    Grid depth(nx, 1);
    for (int x = 0; x < nx; ++x)
        depth(x, 0) = 1.0 + 0.5 * std::cos(2.0 * std::numbers::pi * x / nx);
    const Grid start = depth;
    for (int step = 0; step < 2 * nx; ++step)
        depth = carried(depth, Grid(nx, 1, -1.0), Grid(nx, 1), 0.5);
    for (int x = 0; x < nx; ++x) EXPECT_NEAR(depth(x, 0), start(x, 0), 0.01);
}

}  // namespace
}  // namespace fumon::test
