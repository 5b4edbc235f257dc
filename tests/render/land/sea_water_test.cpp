#include "render/land/sea_water.h"

#include <gtest/gtest.h>

#include "base/snapshot_lookup.h"
#include "render/view/shown_snapshot.h"

namespace fumon {
namespace {

/// Ground that rises eastward from −2 m in steps of 1 m, with a hollow of −3 m inland.
Snapshot coast() {
    Snapshot bed;
    bed.bed = Grid(8, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 8; ++x) bed.bed(x, y) = x - 2.0;
    bed.bed(5, 2) = -3.0;
    bed.scale = {1.0, 1.0, 1.0, true};
    return bed;
}

TEST(SeaWater, FloodsWhatHangsTogetherWithTheEdge) {
    Snapshot bed = coast();
    ASSERT_TRUE(add_sea(bed, 0.5));
    const Grid& depth = *field_of(bed.fields, "water_depth");
    EXPECT_DOUBLE_EQ(depth(0, 2), 2.5);
    EXPECT_DOUBLE_EQ(depth(2, 2), 0.5);
    EXPECT_DOUBLE_EQ(depth(3, 2), 0.0) << "stands over it";
    EXPECT_DOUBLE_EQ(depth(5, 2), 0.0) << "a hollow inland";
    EXPECT_DOUBLE_EQ((*field_of(bed.fields, "velocity_x"))(0, 2), 0.0);
    EXPECT_DOUBLE_EQ(bed.bed(0, 2), -2.0) << "the bed is what it was";
}

TEST(SeaWater, CountsHeightsInMetres) {
    Snapshot bed = coast();
    bed.scale.height_unit = 0.5;
    ASSERT_TRUE(add_sea(bed, 0.25));
    EXPECT_DOUBLE_EQ((*field_of(bed.fields, "water_depth"))(0, 2), 1.25);
}

TEST(SeaWater, BeginsBesideCellsWithoutData) {
    Snapshot bed = coast();
    bed.nodata = Mask(8, 5);
    bed.nodata(5, 1) = 1;
    ASSERT_TRUE(add_sea(bed, -2.5));
    const Grid& depth = *field_of(bed.fields, "water_depth");
    EXPECT_DOUBLE_EQ(depth(5, 2), 0.5);
    EXPECT_DOUBLE_EQ(depth(0, 2), 0.0);
}

TEST(SeaWater, LeavesDeeperWater) {
    Snapshot bed = coast();
    bed.fields.push_back({"water_depth", "", "m", Grid(8, 5, 1.0)});
    ASSERT_TRUE(add_sea(bed, 0.5));
    const Grid& depth = *field_of(bed.fields, "water_depth");
    EXPECT_DOUBLE_EQ(depth(0, 2), 2.5);
    EXPECT_DOUBLE_EQ(depth(2, 2), 1.0);
    EXPECT_DOUBLE_EQ(depth(7, 2), 1.0);
}

TEST(SeaWater, AllBedsButPeriodicOnesHaveItsFields) {
    Snapshot bed = coast();
    EXPECT_TRUE(add_sea(bed, -2.5)) << "over the hollow alone";
    EXPECT_EQ(*field_of(bed.fields, "water_depth"), Grid(8, 5));
    bed = coast();
    bed.periodic = true;
    EXPECT_FALSE(add_sea(bed, 5.0));
    EXPECT_TRUE(bed.fields.empty());
}

TEST(SeaWater, IsDrawnWhereTheLookAsksForIt) {
    View view;
    EXPECT_FALSE(shown_snapshot(coast(), view));
    view.look.sea_level = 0.5;
    const auto shown = shown_snapshot(coast(), view);
    ASSERT_TRUE(shown);
    EXPECT_DOUBLE_EQ((*field_of(shown->fields, "water_depth"))(0, 0), 2.5);
}

}  // namespace
}  // namespace fumon
