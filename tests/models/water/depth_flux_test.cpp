#include "models/water/depth_flux.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/shared/padded_grid.h"
#include "models/water/kernels/depth_vectors.h"
#include "support/grid_values.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

/// With periodic edges and cells of 1 m: as long as no cell gives more than it has, as the strips
/// of CipScheme do it, else by share_depth.
Grid carried(const Grid& depth, const Grid& u, const Grid& v, double dt) {
    const int nx = depth.nx();
    const int ny = depth.ny();
    const auto row = [ny](const Grid& grid, int y) { return grid.row((y + ny) % ny).data(); };
    Grid after(nx, ny);
    bool overdrawn = false;
    for (int y = 0; y < ny; ++y) {
        PaddedGrid h(nx, 1);
        PaddedGrid speed(nx, 1);
        std::copy_n(row(depth, y), nx, h.row(0));
        std::copy_n(row(u, y), nx, speed.row(0));
        h.wrap(0);
        speed.wrap(0);
        const auto count = static_cast<std::size_t>(nx);
        std::vector<double> east(count + 1);
        std::vector<double> south(count);
        std::vector<double> north(count);
        cip::through_faces(
            {h.row(0) - 2, h.row(0) - 1, h.row(0), h.row(0) + 1, speed.row(0) - 1, speed.row(0)},
            dt, nx + 1, east.data());
        const auto along_y = [&](int from, std::vector<double>& faces) {
            cip::through_faces({row(depth, from - 1), row(depth, from), row(depth, from + 1),
                                row(depth, (from + 2) % ny), row(v, from), row(v, from + 1)},
                               dt, nx, faces.data());
        };
        along_y(y - 1, south);
        along_y(y, north);
        overdrawn |= cip::settle_row(row(depth, y), east.data() + 1, south.data(), north.data(),
                                     0.0, nx, after.row(y).data());
    }
    if (overdrawn) share_depth({depth, u, v}, dt, dt, 0.0, after);
    return after;
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
    EXPECT_NEAR(sum(after), sum(depth), 1e-12 * sum(depth));
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
