#include "measure/bed/crest_height.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/measured_beds.h"

namespace fumon {
namespace {

TEST(TopOnePercent, IsTheMeanOfTheHighestCells) {
    // 1050 cells 0 … 1049 in a scattered order: the highest 11 are 1039 … 1049.
    const Grid bed =
        test::bed_of(50, 21, [](int x, int y) { return (17 * (50 * y + x) + 5) % 1050; });
    EXPECT_DOUBLE_EQ(top_one_percent_mean(bed), 1044.0);
}

TEST(TopOnePercent, OfManyCellsIsThatOfAllSorted) {
    for (const bool misled : {false, true}) {  // by a sample of raised cells alone
        Grid bed = test::noise(427, 300, 3);
        for (std::size_t cell = 0; misled && cell < bed.size(); cell += 61)
            bed.values()[cell] += 5.0;
        std::vector<double> heights(bed.values().begin(), bed.values().end());
        std::sort(heights.begin(), heights.end());
        const std::size_t count = (heights.size() + 99) / 100;
        double sum = 0.0;
        for (std::size_t i = heights.size() - count; i < heights.size(); ++i) sum += heights[i];
        EXPECT_EQ(top_one_percent_mean(bed), sum / static_cast<double>(count)) << misled;
    }
}

TEST(TopOnePercent, OfAThousandCellsAreTen) {
    const Grid bed = test::bed_of(100, 10, [](int x, int y) { return (7 * (100 * y + x)) % 1000; });
    EXPECT_DOUBLE_EQ(top_one_percent_mean(bed), 994.5);
}

TEST(TopOnePercent, AgreesWithASortedBed) {
    const Grid bed = test::noise(73, 29, 6);
    std::vector<double> sorted(bed.values().begin(), bed.values().end());
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    double sum = 0.0;
    for (std::size_t i = 0; i < 22; ++i) sum += sorted[i];  // ceil(2117/100)
    EXPECT_NEAR(top_one_percent_mean(bed), sum / 22.0, 1e-14);
}

TEST(TopOnePercent, OfASmallBedIsItsHighestCell) {
    Grid bed(3, 2, -4.0);
    bed(1, 1) = -1.0;
    EXPECT_DOUBLE_EQ(top_one_percent_mean(bed), -1.0);
    EXPECT_TRUE(std::isnan(top_one_percent_mean(Grid())));
}

TEST(CrestToTrough, OfSawtoothsOfTwoHeights) {
    // Rows of teeth 6 high and rows of teeth 2 high, 10 sites each.
    const auto tooth = [](int x, int y) { return (y % 2 == 0 ? 6.0 : 2.0) * (x % 10) / 9.0; };
    const Grid bed = test::bed_of(100, 4, tooth);
    EXPECT_DOUBLE_EQ(crest_to_trough_height(bed, true), 4.0);
    EXPECT_NEAR(crest_to_trough_height(test::bed_of(105, 4, tooth), false), 4.0, 0.2);
}

TEST(CrestToTrough, GoesRoundTheEdge) {
    // One wave whose crest stands at the edge; highest and lowest lie on either side of it.
    const Grid bed = test::moved(test::waves(40, 1, 1.0), 27);
    EXPECT_DOUBLE_EQ(crest_to_trough_height(bed, true), 2.0);
}

TEST(CrestToTrough, IsUndefinedWithoutWaves) {
    EXPECT_TRUE(std::isnan(crest_to_trough_height(Grid(20, 3, 2.0), true)));
    EXPECT_TRUE(std::isnan(crest_to_trough_height(test::waves(20, 3, 0.7), false)));
}

}  // namespace
}  // namespace fumon
