#include "numerics/resampling.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(Resampling, KnownCellsGoOnByThreeRingsOfMeans) {
    Field<double> field(9, 5, 77.0);
    Mask nodata(9, 5, 3);
    for (int y = 0; y < 5; ++y) {
        nodata(0, y) = 0;
        field(0, y) = y;
    }
    extrapolate_outward(field, nodata, -1.0);
    EXPECT_EQ(field(0, 2), 2.0);
    EXPECT_EQ(field(1, 2), 2.0);  // (1 + 2 + 3) / 3
    EXPECT_EQ(field(1, 0), 0.5);
    EXPECT_EQ(field(2, 0), 0.75);  // of 0.5 and 1: those of its own ring do not count
    EXPECT_GT(field(3, 0), 0.75);
    EXPECT_EQ(field(3, 2), 2.0);
    for (int y = 0; y < 5; ++y) EXPECT_EQ(field(4, y), -1.0);
}

TEST(Resampling, NothingIsKnownBesideNothing) {
    Field<double> field(4, 3, 5.0);
    extrapolate_outward(field, Mask(4, 3, 1), 9.0);
    EXPECT_EQ(field, (Field<double>(4, 3, 9.0)));
    EXPECT_TRUE(cells_beside_known(Mask(4, 3, 1)).empty());
    EXPECT_TRUE(cells_beside_known(Mask(4, 3, 0)).empty());
}

}  // namespace
}  // namespace fumon
