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
    EXPECT_FALSE(shown_snapshot(of(Grid(2000, 2)), {}));
    EXPECT_FALSE(shown_snapshot(of(Grid(1, 1)), {}));
}

TEST(ShownSnapshot, AProfileBecomesAStripOfTheSitesAskedFor) {
    Grid row(1000, 1);
    for (int x = 0; x < 1000; ++x) row(x, 0) = x;
    Snapshot profile = of(row);
    profile.fields.push_back({"twice", "", "1", row});
    View view;
    LookSettings& look = view.look;
    EXPECT_EQ(shown_snapshot(profile, view)->bed.nx(), 900);
    look.profile_start = 990;
    look.profile_sites = 40;
    const auto strip = shown_snapshot(profile, view);
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
    View view;
    view.camera.distance = {"", 1.0};
    const auto shown = shown_snapshot(huge, view);
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

TEST(ShownSnapshot, ABedOfMoreCellsThanPixelsIsAveragedWhereAllOfItIsSeen) {
    Snapshot bed = of(Grid(4100, 3));
    View view;
    const auto columns = [&] {
        const auto shown = shown_snapshot(bed, view);
        return shown ? shown->bed.nx() : bed.bed.nx();
    };
    view.image.width = 1920;
    view.image.height = 1080;
    EXPECT_EQ(columns(), 2050);
    view.image.height = 2100;  // the longer side counts: still one cell a pixel at the least
    EXPECT_EQ(columns(), 4100);
    view.image.width = view.image.height = 64;
    EXPECT_EQ(columns(), 1025);
    const View small = view;
    view.camera.distance = {"", 0.2};  // what is near may be large
    EXPECT_EQ(columns(), 4100);
    view = small;
    view.camera.look_at = {1.0, 1.0, 0.0};
    EXPECT_EQ(columns(), 4100);
    view = small;
    view.camera.at = {1.0, 1.0, 1.0};
    EXPECT_EQ(columns(), 4100);
    view = small;
    view.look.ground = Ground::endless;
    EXPECT_EQ(columns(), 820) << "in a plain";
    bed.periodic = true;
    EXPECT_EQ(columns(), 4100);
}

TEST(ShownSnapshot, AnAveragedBedKeepsWhatIsNoField) {
    Snapshot bed = of(Grid(4096, 2, 1.0));
    bed.step = 7;
    bed.time = 3.5;
    bed.time_unit = "s";
    bed.scale.in_metres = true;
    bed.highest_expected = 2.0;
    bed.periodic = true;
    bed.fields.push_back({"depth", "how deep", "m", Grid(4096, 2, 4.0)});
    bed.numbers.push_back({"lost", "1", 5.0});
    bed.landform = Landform::water;
    bed.winds = {{0.0, 1.0, 3.0}};
    View view;
    view.look.ground = Ground::table;
    const auto shown = shown_snapshot(bed, view);
    ASSERT_TRUE(shown);
    ASSERT_EQ(shown->winds.size(), 1U);
    EXPECT_EQ(shown->winds[0].y, 1.0);
    EXPECT_EQ(shown->step, 7);
    EXPECT_EQ(shown->time, 3.5);
    EXPECT_EQ(shown->time_unit, "s");
    EXPECT_TRUE(shown->scale.in_metres);
    EXPECT_EQ(shown->highest_expected, 2.0);
    EXPECT_TRUE(shown->periodic);
    ASSERT_EQ(shown->fields.size(), 1U);
    EXPECT_EQ(shown->fields.front().name, "depth");
    EXPECT_EQ(shown->fields.front().long_name, "how deep");
    EXPECT_EQ(shown->fields.front().unit, "m");
    EXPECT_EQ(shown->fields.front().values(2047, 0), 4.0);
    EXPECT_EQ(shown->numbers.size(), 1U);
    EXPECT_EQ(shown->landform, Landform::water);
}

TEST(Marking, GroundShowsPlantsAboveAndRockBelowBareSand) {
    Snapshot dunes;
    dunes.bed = Grid(12, 9, 1.0);
    dunes.periodic = true;
    EXPECT_EQ(marked_field(Marking::ground, dunes), nullptr);
    Grid sand(12, 9, 0.5);
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 9; ++y) sand(x, y) = 0.0;
    }
    dunes.fields = {{"sand", "", "m", sand}};
    EXPECT_EQ(marked_field(Marking::ground, dunes)->name, "sand");
    auto marks = mark_texels(Marking::ground, dunes);
    EXPECT_EQ(marks(2, 4), 0) << "rock";
    EXPECT_EQ(marks(8, 4), 128) << "sand";
    EXPECT_EQ(marks(3, 4), 8) << "softened by a sixteenth";
    EXPECT_EQ(marks(4, 4), 40) << "and by five";
    EXPECT_EQ(marks(0, 4), 40) << "round the bed";
    Grid cover(12, 9);
    for (int y = 0; y < 9; ++y) cover(7, y) = cover(8, y) = cover(9, y) = 1.0;
    dunes.fields.push_back({"cover", "", "1", cover});
    marks = mark_texels(Marking::ground, dunes);
    EXPECT_GT(marks(8, 4), 175) << "plants";
    EXPECT_NE(marks(8, 4), marks(8, 5)) << "in tufts";
    EXPECT_EQ(marks(2, 4), 0);
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
