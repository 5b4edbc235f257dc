#include "render/view/shown_snapshot.h"

#include <gtest/gtest.h>

#include "render/colour/colouring.h"

namespace fumon {
namespace {

Snapshot of(Grid bed) {
    Snapshot snapshot;
    snapshot.bed = std::move(bed);
    return snapshot;
}

TEST(ShownSnapshot, AnOrdinaryBedIsDrawnAsItIs) {
    EXPECT_FALSE(shown_snapshot(of(Grid(100, 80)), {}));
    EXPECT_FALSE(shown_snapshot(of(Grid(8192, 2)), {}));
    EXPECT_FALSE(shown_snapshot(of(Grid(1, 1)), {}));
}

TEST(ShownSnapshot, AProfileBecomesAStripOfTheSitesAskedFor) {
    Grid row(1000, 1);
    for (int x = 0; x < 1000; ++x) row(x, 0) = x;
    Snapshot profile = of(row);
    profile.fields.push_back({"twice", "", "1", row});
    LookSettings look;
    EXPECT_EQ(shown_snapshot(profile, look)->bed.nx(), 900);
    look.profile_start = 990;
    look.profile_sites = 40;
    const auto strip = shown_snapshot(profile, look);
    ASSERT_TRUE(strip);
    ASSERT_EQ(strip->bed.nx(), 40);
    ASSERT_EQ(strip->bed.ny(), 10);
    EXPECT_EQ(strip->bed(0, 9), 990.0);
    EXPECT_EQ(strip->bed(9, 0), 999.0);
    EXPECT_EQ(strip->bed(10, 5), 0.0);  // the profile goes on from its beginning
    EXPECT_EQ(strip->fields.front().values(12, 3), 2.0);
    EXPECT_EQ(strip->scale.dx, 1.0);
}

TEST(ShownSnapshot, AHugeBedIsAveraged) {
    Snapshot huge = of(Grid(16385, 5));  // three cells become one
    huge.scale.dx = 2.0;
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < huge.bed.nx(); ++x) huge.bed(x, y) = x + 10.0 * y;
    }
    huge.nodata = Mask(16385, 5);
    huge.nodata(0, 0) = 1;
    for (int y = 3; y < 5; ++y) huge.nodata(16384, y) = huge.nodata(16383, y) = 1;
    const auto shown = shown_snapshot(huge, {});
    ASSERT_TRUE(shown);
    ASSERT_EQ(shown->bed.nx(), 5462);
    ASSERT_EQ(shown->bed.ny(), 2);
    EXPECT_DOUBLE_EQ(shown->bed(1, 0), 14.0);        // of x 3 … 5 and y 0 … 2
    EXPECT_DOUBLE_EQ(shown->bed(0, 0), 99.0 / 8.0);  // without the masked cell
    EXPECT_DOUBLE_EQ(shown->bed(1, 1), 39.0);        // of two rows
    EXPECT_EQ(shown->nodata(0, 0), 0);
    EXPECT_EQ(shown->nodata(5461, 1), 1);
    EXPECT_DOUBLE_EQ(shown->scale.dx, 6.0);
}

TEST(Marking, ToppledCellsStandOutMostAndOthersNotAtAll) {
    Snapshot pile = of(Grid(3, 1));
    EXPECT_EQ(marked_field(Marking::last_avalanche, pile), nullptr);
    pile.fields.push_back({"last_avalanche", "", "1", Grid(3, 1)});
    pile.fields.front().values(1, 0) = 1.0;
    pile.fields.front().values(2, 0) = 4.0;
    EXPECT_EQ(marked_field(Marking::none, pile), nullptr);
    const auto marks = mark_texels(Marking::last_avalanche, pile);
    EXPECT_EQ(marks(0, 0), 0);
    EXPECT_GT(marks(1, 0), 60);
    EXPECT_GT(marks(2, 0), marks(1, 0) + 60);
    EXPECT_EQ(mark_texels(Marking::none, pile).size(), 1U);
}

}  // namespace
}  // namespace fumon
