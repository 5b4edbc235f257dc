#include "files/terrain/resample_terrain.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/grid_values.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::sum;

/// z = 3x + 5y at the centres of cells of `dx` × `dy`, which lie from (100, 200) on.
Terrain plane(int nx, int ny, double dx, double dy) {
    Terrain terrain;
    terrain.heights = Grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            terrain.heights(x, y) = 3.0 * (x + 0.5) * dx + 5.0 * (y + 0.5) * dy;
    }
    terrain.dx = dx;
    terrain.dy = dy;
    terrain.place = {100.0, 200.0, dx, dy};
    return terrain;
}

Terrain onto(const Terrain& terrain, double size, Resampling method) {
    return resampled(terrain, terrain.dx, terrain.dy, size, method, "bed.resample");
}

TEST(ResampledTerrain, APlaneStaysAPlane) {
    for (const Resampling method : {Resampling::average, Resampling::bilinear}) {
        const Terrain made = onto(plane(12, 8, 1.0, 2.0), 4.0, method);
        ASSERT_EQ(made.heights.nx(), 3);
        ASSERT_EQ(made.heights.ny(), 4);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 3; ++x) {
                EXPECT_NEAR(made.heights(x, y), 3.0 * (x + 0.5) * 4.0 + 5.0 * (y + 0.5) * 4.0,
                            1e-12);
            }
        }
        EXPECT_EQ(made.place, (GeoReference{100.0, 200.0, 4.0, 4.0}));
    }
    const Terrain finer = onto(plane(4, 4, 1.0, 1.0), 0.25, Resampling::bilinear);
    EXPECT_EQ(finer.heights.nx(), 16);
    EXPECT_NEAR(finer.heights(7, 9), 3.0 * 7.5 * 0.25 + 5.0 * 9.5 * 0.25, 1e-12);
}

TEST(ResampledTerrain, AnAverageKeepsTheVolume) {
    Terrain terrain = plane(15, 10, 1.0, 1.0);
    for (std::size_t k = 0; k < terrain.heights.size(); ++k)
        terrain.heights.values()[k] = static_cast<double>(k * k % 37);
    const Terrain made = onto(terrain, 2.5, Resampling::average);
    ASSERT_EQ(made.heights.nx(), 6);
    ASSERT_EQ(made.heights.ny(), 4);
    EXPECT_NEAR(sum(made.heights) * 2.5 * 2.5, sum(terrain.heights), 1e-9);
    EXPECT_GT(std::abs(sum(onto(terrain, 2.5, Resampling::nearest).heights) * 6.25 -
                       sum(terrain.heights)),
              1.0)
        << "which single cells do not";
}

TEST(ResampledTerrain, TheNearestTakesHeightsAsTheyStand) {
    const Terrain made = onto(plane(6, 6, 1.0, 1.0), 2.0, Resampling::nearest);
    EXPECT_EQ(made.heights(0, 0), plane(6, 6, 1.0, 1.0).heights(1, 1));
    EXPECT_EQ(made.heights(2, 1), plane(6, 6, 1.0, 1.0).heights(5, 3));
}

TEST(ResampledTerrain, WhatRemainsAtTheEdgesFallsAway) {
    const Terrain made = onto(plane(10, 7, 1.0, 1.0), 3.0, Resampling::average);
    EXPECT_EQ(made.heights.nx(), 3);
    EXPECT_EQ(made.heights.ny(), 2);
    EXPECT_EQ(made.place->west, 100.0);
    EXPECT_EQ(onto(plane(3, 3, 0.1, 0.1), 0.1, Resampling::average).heights.nx(), 3)
        << "rounding takes no cell away";
}

TEST(ResampledTerrain, HolesStayHoles) {
    Terrain terrain = plane(4, 2, 1.0, 1.0);
    terrain.nodata = Mask(4, 2);
    terrain.nodata(0, 0) = terrain.nodata(1, 0) = terrain.nodata(0, 1) = 1;
    terrain.nodata(2, 0) = 1;
    for (std::size_t k = 0; k < 8; ++k) {
        if (terrain.nodata.values()[k] != 0) terrain.heights.values()[k] = 1e6;
    }
    const Terrain made = onto(terrain, 2.0, Resampling::average);
    ASSERT_FALSE(made.nodata.empty());
    EXPECT_EQ(made.nodata(0, 0), 1) << "three of its four cells";
    EXPECT_EQ(made.nodata(1, 0), 0) << "one of its four";
    const double known = terrain.heights(3, 0) + terrain.heights(2, 1) + terrain.heights(3, 1);
    EXPECT_NEAR(made.heights(1, 0), known / 3.0, 1e-12);
    const Terrain finer = onto(terrain, 0.5, Resampling::bilinear);
    EXPECT_EQ(finer.nodata(5, 1), 1);
    EXPECT_EQ(finer.nodata(6, 1), 0);
    EXPECT_LT(finer.heights(6, 1), 100.0) << "holes lend no height";
}

TEST(ResampledTerrain, CellsThatDoNotFitAreRefused) {
    EXPECT_EQ(
        message_of<InputError>([] { (void)onto(plane(4, 2, 1.0, 1.0), 3.0, Resampling::average); }),
        "bed.resample is 3 m, more than the terrain's 4 x 2 m; take smaller cells");
    EXPECT_EQ(message_of<InputError>(
                  [] { (void)onto(plane(4, 2, 1.0, 1.0), 1e-4, Resampling::average); }),
              "bed.resample is 0.0001 m: 40000 x 20000 cells are too many, at most 134217728");
}

}  // namespace
}  // namespace fumon
