#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

Grid plane(int nx, int ny) {
    Grid grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) grid(x, y) = 3.0 + 0.5 * x - 0.25 * y;
    }
    return grid;
}

void punch(Grid& grid, Mask& mask, int x, int y) {
    grid(x, y) = 0.0;
    mask(x, y) = 1;
}

double largest_difference(const Grid& a, const Grid& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a.values()[i] - b.values()[i]));
    return largest;
}

// Planes are harmonic: a hole inside one is filled with the plane itself.
TEST(FillNoData, RestoresAPlane) {
    const Grid whole = plane(40, 30);
    Grid holed = whole;
    Mask mask(40, 30);
    for (int y = 1; y < 29; ++y) {
        for (int x = 1; x < 39; ++x) {
            if (std::hypot(x - 20, y - 15) < 9 || (x + 3 * y) % 7 == 0) punch(holed, mask, x, y);
        }
    }
    EXPECT_LT(largest_difference(fill_nodata(holed, mask), whole), 1e-11);
}

TEST(FillNoData, SolvesTheLaplaceEquationByHand) {
    Grid grid(3, 3, 1.0);
    Mask mask(3, 3);
    grid(1, 0) = 2.0;
    grid(0, 1) = 4.0;
    punch(grid, mask, 1, 1);
    punch(grid, mask, 2, 2);  // a corner: the mean of its two neighbours
    const Grid filled = fill_nodata(grid, mask);
    EXPECT_NEAR(filled(1, 1), (2.0 + 4.0 + 1.0 + 1.0) / 4.0, 1e-14);
    EXPECT_NEAR(filled(2, 2), 1.0, 1e-14);
}

// At the edge of the grid nothing is prescribed: the bed runs out level.
TEST(FillNoData, RunsOutLevelAtTheBorder) {
    Grid grid(20, 5);
    Mask mask(20, 5);
    for (int y = 0; y < 5; ++y) {
        grid(0, y) = 7.0;
        for (int x = 1; x < 20; ++x) punch(grid, mask, x, y);
    }
    const Grid filled = fill_nodata(grid, mask);
    for (const double height : filled.values()) EXPECT_NEAR(height, 7.0, 1e-12);
}

TEST(FillNoData, LeavesDataAloneAndStaysWithinIt) {
    Grid grid(50, 50);
    Mask mask(50, 50);
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 50; ++x) {
            grid(x, y) = std::sin(0.7 * x) + std::cos(0.3 * x * y);
            if ((x * 7 + y * 13) % 5 < 3) punch(grid, mask, x, y);
        }
    }
    const Grid filled = fill_nodata(grid, mask);
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 50; ++x) {
            if (mask(x, y) == 0) {
                EXPECT_EQ(filled(x, y), grid(x, y));
            }
            EXPECT_LE(std::abs(filled(x, y)), 2.0);
        }
    }
}

// Beyond 300,000 hole cells, where filling is iterative.
TEST(FillNoData, RestoresAPlaneWithALargeHole) {
    const Grid whole = plane(600, 550);
    Grid holed = whole;
    Mask mask(600, 550);
    for (int y = 1; y < 549; ++y) {
        for (int x = 1; x < 599; ++x) punch(holed, mask, x, y);
    }
    const double relief = 0.5 * 599 + 0.25 * 549;
    EXPECT_LT(largest_difference(fill_nodata(holed, mask), whole), 1e-3 * relief);
}

TEST(FillNoData, ReturnsAWholeBedAsItIs) {
    EXPECT_EQ(fill_nodata(plane(4, 3), {}), plane(4, 3));
    EXPECT_EQ(fill_nodata(plane(4, 3), Mask(4, 3)), plane(4, 3));
}

TEST(FillNoData, RefusesABedWithoutData) {
    EXPECT_EQ(
        test::message_of<InputError>([] { fill_nodata(Grid(4, 3), Mask(4, 3, 1)); }),
        "every cell is no-data, so there is nothing to fill from; give a terrain with at least "
        "one height");
}

}  // namespace
}  // namespace fumon
