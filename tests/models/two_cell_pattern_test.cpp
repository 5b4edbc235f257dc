#include "models/shared/two_cell_pattern.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

/// Furrows along the columns, so many cells apart, in the western half of what has sunk evenly.
Grid furrowed(double wavelength, double depth) {
    Grid change(60, 40, -1.0);
    for (int y = 0; y < 40; ++y)
        for (int x = 4; x < 30; ++x)
            change(x, y) -= depth * (1.0 + std::cos(2.0 * M_PI * x / wavelength));
    return change;
}

TEST(TwoCellPattern, IsFoundWhereEverySecondCellIsAFurrow) {
    const TwoCellPattern found = two_cell_pattern(furrowed(2.0, 0.5));
    EXPECT_NEAR(found.share, 26.0 / 60.0, 0.05);
    EXPECT_LT(found.cell % 60, 30U);
    Grid along(40, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 40; ++x) along(x, y) = furrowed(2.0, 0.5)(y, x);
    EXPECT_DOUBLE_EQ(two_cell_pattern(along).share, found.share);
}

TEST(TwoCellPattern, IsNeitherWiderFurrowsNorASingleOneNorNothing) {
    for (const double wavelength : {4.0, 5.0, 8.0})
        EXPECT_EQ(two_cell_pattern(furrowed(wavelength, 0.5)).share, 0.0) << wavelength;
    EXPECT_EQ(two_cell_pattern(furrowed(2.0, 0.05)).share, 0.0) << "too shallow to matter";
    Grid one(60, 40, -1.0);
    for (int y = 0; y < 40; ++y) one(20, y) = -5.0;
    EXPECT_EQ(two_cell_pattern(one).share, 0.0);
    EXPECT_EQ(two_cell_pattern(Grid(5, 3, 0.0)).share, 0.0);
}

}  // namespace
}  // namespace fumon
