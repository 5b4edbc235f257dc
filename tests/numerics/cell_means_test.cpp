// Linear velocities from means over cells (numerics/cell_means.h), and where water's centre of mass
// lies in a cell that is partly wet (numerics/clipped_plane.h).

#include "numerics/cell_means.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numerics/clipped_plane.h"

namespace fumon {
namespace {

using cell_means::Patch;

struct Flow {
    Patch depth{};
    Patch carried{};
};

/// Means of h = 1.2 + hx·x + hy·y + … and of h·u, u = 0.4 + ux·x + uy·y, over nine cells, by
/// Simpson's rule, which is exact here.
Flow flow_of(double hx, double hy, double ux, double uy) {
    Flow flow;
    for (std::size_t k = 0; k < flow.depth.size(); ++k) {
        for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) {
                const double x = static_cast<double>(k % 3) - 1.0 + 0.5 * i;
                const double y = static_cast<double>(k / 3) - 1.0 + 0.5 * j;
                const double weight = (i == 0 ? 4.0 : 1.0) * (j == 0 ? 4.0 : 1.0) / 36.0;
                const double h = 1.2 + hx * x + hy * y - 0.06 * x * x + 0.03 * x * y - 0.05 * y * y;
                flow.depth[k] += weight * h;
                flow.carried[k] += weight * (h * (0.4 + ux * x + uy * y));
            }
        }
        flow.carried[k] /= flow.depth[k];
    }
    return flow;
}

TEST(CellMeans, OfLinearVelocityGiveItBackWhereTheDepthFallsToAShore) {
    for (const auto& [hx, hy] : {std::pair{0.5, 0.1}, {-0.2, 0.4}, {0.0, -0.5}}) {
        const Flow flow = flow_of(hx, hy, 0.3, -0.2);
        const auto u = cell_means::velocity_of(flow.depth, flow.carried, 1.3);
        EXPECT_NEAR(u.middle, 0.4, 2e-4) << hx;
        EXPECT_NEAR(u.along_x, 0.3, 2e-3) << hx;
        EXPECT_NEAR(u.along_y, -0.2, 2e-3) << hx;
        EXPECT_GT(std::fabs(flow.carried[4] - 0.4), 5e-3) << hx;
    }
}

TEST(CellMeans, ThinWaterBesideDoesNotMakeAVelocityOfItsOwn) {
    Flow flow;
    flow.depth = {1e-6, 1e-6, 1e-6, 1e-6, 0.5, 1.0, 1e-6, 0.5, 1.0};
    flow.carried = {0.0, 0.1, 0.2, 0.0, 0.1, 0.2, 0.0, 0.1, 0.2};
    const auto u = cell_means::velocity_of(flow.depth, flow.carried, 1.3);
    EXPECT_GT(u.middle, 0.05);
    EXPECT_LT(u.middle, 0.15);
    EXPECT_GT(u.along_x, 0.05);
    EXPECT_LT(u.along_x, 0.2);
}

TEST(CellMeans, MirrorImagesAndExchangedAxesAreTheSameToTheLastBit) {
    const Flow flow = flow_of(0.5, 0.13, 0.31, -0.22);
    Flow mirror;
    Flow exchange;
    for (std::size_t k = 0; k < flow.depth.size(); ++k) {
        const std::size_t x = k % 3;
        const std::size_t y = k / 3;
        mirror.depth[3 * y + 2 - x] = flow.depth[k];
        mirror.carried[3 * y + 2 - x] = 0.0 - flow.carried[k];
        exchange.depth[3 * x + y] = flow.depth[k];
        exchange.carried[3 * x + y] = flow.carried[k];
    }
    const auto u = cell_means::velocity_of(flow.depth, flow.carried, 1.3);
    const auto mirrored = cell_means::velocity_of(mirror.depth, mirror.carried, 1.3);
    const auto exchanged = cell_means::velocity_of(exchange.depth, exchange.carried, 1.3);
    EXPECT_EQ(mirrored.middle, 0.0 - u.middle);
    EXPECT_EQ(mirrored.along_x, u.along_x);
    EXPECT_EQ(mirrored.along_y, 0.0 - u.along_y);
    EXPECT_EQ(exchanged.middle, u.middle);
    EXPECT_EQ(exchanged.along_x, u.along_y);
    EXPECT_EQ(exchanged.along_y, u.along_x);
}

TEST(ClippedPlane, CentresOfMassAreThoseOfManySamples) {
    constexpr int samples = 400;
    for (const auto& [rise_x, rise_y] :
         {std::pair{0.4, 0.1}, {-0.1, 0.3}, {0.2, -0.2}, {0.0, 0.3}, {-0.3, 0.0}}) {
        for (const double depth : {-0.12, -0.05, 0.01, 0.08, 0.14, 0.3}) {
            double volume = 0.0;
            double along_x = 0.0;
            double along_y = 0.0;
            for (int j = 0; j < samples; ++j) {
                for (int i = 0; i < samples; ++i) {
                    const double x = (i + 0.5) / samples - 0.5;
                    const double y = (j + 0.5) / samples - 0.5;
                    const double h = std::max(depth + rise_x * x + rise_y * y, 0.0);
                    volume += h;
                    along_x += h * x;
                    along_y += h * y;
                }
            }
            const auto centre = clipped_plane::centre_of_mass(depth, rise_x, rise_y);
            EXPECT_NEAR(centre.x, volume > 0.0 ? along_x / volume : 0.0, 1e-4) << depth;
            EXPECT_NEAR(centre.y, volume > 0.0 ? along_y / volume : 0.0, 1e-4) << depth;
            const auto exchanged = clipped_plane::centre_of_mass(depth, rise_y, rise_x);
            EXPECT_EQ(exchanged.x, centre.y);
            EXPECT_EQ(exchanged.y, centre.x);
        }
    }
    const auto along = clipped_plane::means_along(0.05, 0.3);
    EXPECT_NEAR(along.centre, 0.5 - (0.2 / 0.3) / 3.0, 1e-15);
    EXPECT_NEAR(clipped_plane::means_along(0.05, -0.3).centre, 0.0 - along.centre, 1e-15);
    EXPECT_NEAR(clipped_plane::means_along(0.5, 0.3).centre, 0.05, 1e-15);
}

}  // namespace
}  // namespace fumon
