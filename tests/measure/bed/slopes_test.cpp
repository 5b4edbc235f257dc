#include "measure/bed/slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/measured_beds.h"

namespace fumon {
namespace {

/// Waves of 12 sites that rise 6 heights over `rise` of them and fall over the others.
Grid sawtooth(int rise) {
    return test::bed_of(60, 4, [=](int x, int y) {
        const int site = (x + 5 * y) % 12;
        return 1.0 + (site < rise ? 6.0 * site / rise : 6.0 * (12 - site) / (12 - rise));
    });
}

TEST(BedSlopes, OfASawtoothWithASteepLeeSide) {
    const BedSlopes found = bed_slopes(sawtooth(10), true);
    EXPECT_NEAR(found.stoss, 0.6, 1e-12);
    EXPECT_NEAR(found.lee, 3.0, 1e-12);
    EXPECT_NEAR(found.steep_stoss, 0.6, 1e-12);
    EXPECT_NEAR(found.steep_lee, 3.0, 1e-12);
    EXPECT_NEAR(found.stoss_to_lee, 0.2, 1e-12);
}

TEST(BedSlopes, OfASawtoothWithASteepStossSide) {
    const BedSlopes found = bed_slopes(sawtooth(3), true);
    EXPECT_NEAR(found.stoss, 2.0, 1e-12);
    EXPECT_NEAR(found.lee, 6.0 / 9.0, 1e-12);
    EXPECT_NEAR(found.stoss_to_lee, 3.0, 1e-12);
}

TEST(BedSlopes, OfASineAreAlike) {
    const BedSlopes found = bed_slopes(test::waves(128, 3, 4.0), true);
    EXPECT_NEAR(found.stoss_to_lee, 1.0, 1e-9);
    EXPECT_NEAR(found.stoss, 4.0 / 32.0, 1e-3);  // 2 heights in half of 32 sites
    EXPECT_NEAR(found.steep_stoss, found.steep_lee, 1e-9);
}

TEST(BedSlopes, ThePercentileIsTheOneThatNineTenthsDoNotExceed) {
    // Rises of 1, 2 … 20, then one fall.
    const Grid bed = test::bed_of(21, 1, [](int x, int) { return 0.5 * x * (x + 1); });
    const BedSlopes found = bed_slopes(bed, true);
    EXPECT_DOUBLE_EQ(found.steep_stoss, 18.0);
    EXPECT_DOUBLE_EQ(found.stoss, 10.5);
    EXPECT_DOUBLE_EQ(found.lee, 210.0);
}

TEST(BedSlopes, OfAnOpenBedStopAtItsEdge) {
    const Grid ramp = test::bed_of(10, 3, [](int x, int) { return 0.25 * x; });
    const BedSlopes found = bed_slopes(ramp, false);
    EXPECT_DOUBLE_EQ(found.stoss, 0.25);
    EXPECT_TRUE(std::isnan(found.lee));
    EXPECT_TRUE(std::isnan(found.stoss_to_lee));
}

TEST(BedSlopes, LevelGroundIsOnNeitherSide) {
    Grid bed(40, 2, 0.0);
    for (int y = 0; y < 2; ++y) {
        bed(10, y) = 1.0;
        bed(11, y) = 2.0;
    }
    const BedSlopes found = bed_slopes(bed, true);
    EXPECT_DOUBLE_EQ(found.stoss, 1.0);
    EXPECT_DOUBLE_EQ(found.lee, 2.0);
    EXPECT_TRUE(std::isnan(bed_slopes(Grid(10, 2, 0.7), true).stoss));
}

TEST(BedSlopes, AreMeasuredBetweenHoles) {
    Grid bed = sawtooth(10);
    const BedSlopes whole = bed_slopes(bed, true);
    Mask nodata(bed.nx(), bed.ny());
    for (int y = 0; y < bed.ny(); ++y) {  // a period of the sawtooth
        for (int x = 10; x < 20; ++x) {
            nodata(x, y) = 1;
            bed(x, y) = -500.0;
        }
    }
    const BedSlopes found = bed_slopes(bed, false, nodata);
    EXPECT_NEAR(found.stoss, whole.stoss, 1e-9);
    EXPECT_NEAR(found.lee, whole.lee, 1e-9);
    EXPECT_TRUE(std::isnan(bed_slopes(bed, true, Mask(bed.nx(), bed.ny(), 1)).stoss));
}

TEST(BedSlopes, OfManySitesAreThoseOfAllSorted) {
    Grid bed = test::noise(331, 300, 4);
    for (int y = 0; y < 300; ++y) bed(7, y) = 40.0 + y;  // spikes, which no sample foresees
    for (const bool periodic : {true, false}) {
        std::vector<double> rises;
        std::vector<double> falls;
        for (int y = 0; y < bed.ny(); ++y) {
            for (int x = 0; x < (periodic ? bed.nx() : bed.nx() - 1); ++x) {
                const double difference = bed((x + 1) % bed.nx(), y) - bed(x, y);
                (difference > 0.0 ? rises : falls).push_back(std::abs(difference));
            }
        }
        const BedSlopes found = bed_slopes(bed, periodic);
        for (auto* side : {&rises, &falls}) {
            const double sum = std::accumulate(side->begin(), side->end(), 0.0);
            const double mean = sum / static_cast<double>(side->size());
            std::sort(side->begin(), side->end());
            const double steep = (*side)[(side->size() * 9 + 9) / 10 - 1];
            EXPECT_NEAR(side == &rises ? found.stoss : found.lee, mean, 1e-12);
            EXPECT_EQ(side == &rises ? found.steep_stoss : found.steep_lee, steep);
        }
    }
}

}  // namespace
}  // namespace fumon
