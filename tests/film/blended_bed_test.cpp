#include "film/beds/blended_bed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

TEST(BlendedBed, MarksAndMissingValuesAreTheNearerOnes) {
    Snapshot one;
    one.bed = Grid(2, 1);
    one.fields = {{"last_avalanche", "", "1", Grid(2, 1)}, {"water_depth", "", "m", Grid(2, 1)}};
    one.numbers = {{"wind_from", "degrees", 350.0}, {"sand_volume", "m3", 8.0}};
    Snapshot other = one;
    other.nodata = Mask(2, 1);
    other.nodata(1, 0) = 1;
    other.fields[0].values(0, 0) = 1.0;
    other.fields[1].values(0, 0) = 4.0;
    other.fields[1].values(1, 0) = NAN;
    other.numbers[0].value = 10.0;
    other.numbers[1].value = 4.0;
    const Snapshot near = blended(one, other, 0.25);
    EXPECT_EQ(near.fields[0].values(0, 0), 0.0);
    EXPECT_EQ(near.fields[1].values(0, 0), 1.0);
    EXPECT_EQ(near.fields[1].values(1, 0), 0.0);
    EXPECT_EQ(near.nodata, other.nodata);
    EXPECT_EQ(near.numbers[0].value, 350.0);
    EXPECT_EQ(near.numbers[1].value, 7.0);
    const Snapshot far = blended(one, other, 0.75);
    EXPECT_EQ(far.fields[0].values(0, 0), 1.0);
    EXPECT_EQ(far.numbers[0].value, 10.0);
    EXPECT_TRUE(std::isnan(far.fields[1].values(1, 0)));
}

}  // namespace
}  // namespace fumon
