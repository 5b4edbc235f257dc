#include "measure/bed/bed_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

TEST(BedStatistics, OfAKnownBed) {
    Grid bed(2, 2);
    bed(0, 0) = 1.0;
    bed(1, 0) = 2.0;
    bed(0, 1) = 3.0;
    bed(1, 1) = 6.0;
    const BedStatistics found = bed_statistics(bed, {});
    EXPECT_DOUBLE_EQ(found.mean, 3.0);
    EXPECT_DOUBLE_EQ(found.standard_deviation, std::sqrt(3.5));
    EXPECT_DOUBLE_EQ(found.minimum, 1.0);
    EXPECT_DOUBLE_EQ(found.maximum, 6.0);
    EXPECT_DOUBLE_EQ(found.total, 12.0);
}

TEST(BedStatistics, LeavesOutCellsWithoutData) {
    Grid bed(3, 1, -5.0);
    bed(1, 0) = 4.0;
    Mask nodata(3, 1, 1);
    nodata(1, 0) = 0;
    const BedStatistics found = bed_statistics(bed, nodata);
    EXPECT_DOUBLE_EQ(found.mean, 4.0);
    EXPECT_DOUBLE_EQ(found.minimum, 4.0);
    EXPECT_DOUBLE_EQ(found.standard_deviation, 0.0);
}

TEST(BedStatistics, TheTotalDoesNotLoseSmallHeights) {
    Grid bed(1001, 1, 1e-16);
    bed(0, 0) = 1.0;  // a plain sum would stay 1
    EXPECT_DOUBLE_EQ(bed_statistics(bed, {}).total, 1.0 + 1e-13);
}

}  // namespace
}  // namespace fumon
