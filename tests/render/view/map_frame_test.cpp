// Where the pixels of a map picture lie: a patch of the bed is drawn where its coordinates say.

#include "render/view/map_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "support/drawn_picture.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

/// A flat bed of 40 × 25 cells of 10 m at (500 km, 4400 km), with a plateau over some of them.
Snapshot plateau(int x0, int x1, int y0, int y1) {
    Snapshot snapshot = flat_bed(40, 25);
    snapshot.scale = {10.0, 10.0, 1.0, true,
                      GeoReference{500000.0, 4400000.0, 10.0, 10.0, false, "PROJCRS[\"<a>\"]"}};
    for (double& height : snapshot.bed.values()) height = 0.0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) snapshot.bed(x, y) = 1.0;
    return snapshot;
}

View map_of_heights() {
    View view = small_view(640, 480);
    view.camera.projection = Projection::map;
    view.look.mode = ViewMode::figure;
    view.look.colour_by = Colouring::height;
    view.look.palette = "viridis";
    view.look.shading = 0.0;
    view.look.grain = 0.0;
    return view;
}

TEST(MapFrame, APatchIsDrawnWhereItsCoordinatesSay) {
    const Snapshot snapshot = plateau(30, 34, 3, 5);
    const View view = map_of_heights();
    const MapFrame frame = map_frame(view, snapshot, "output.world_files");
    const Image image = picture(view, snapshot);
    // Between dark (low) and bright (high) the palette's green rises: half way is the edge of
    // cells.
    double west = 1e300;
    double east = -1e300;
    double south = 1e300;
    double north = -1e300;
    for (int j = 0; j < image.height; ++j) {
        for (int i = 0; i < image.width; ++i) {
            const std::uint8_t* pixel = image.row(j) + 3 * static_cast<std::size_t>(i);
            const bool high = pixel[1] > 150 && pixel[2] < 100;  // viridis' yellow end
            if (!high) continue;
            west = std::min(west, frame.west + i * frame.pixel_x);
            east = std::max(east, frame.west + (i + 1) * frame.pixel_x);
            north = std::max(north, frame.north - j * frame.pixel_y);
            south = std::min(south, frame.north - (j + 1) * frame.pixel_y);
        }
    }
    // Colours change between the centres of two cells: within half a cell, the same on all sides.
    const double cell = 10.0;
    EXPECT_NEAR(west, 500300.0, 0.5 * cell);
    EXPECT_NEAR(east, 500350.0, 0.5 * cell);
    EXPECT_NEAR(south, 4400030.0, 0.5 * cell);
    EXPECT_NEAR(north, 4400060.0, 0.5 * cell);
    const double pixel = std::max(frame.pixel_x, frame.pixel_y);
    EXPECT_NEAR(0.5 * (west + east), 500325.0, pixel);
    EXPECT_NEAR(0.5 * (south + north), 4400045.0, pixel);
}

TEST(MapFrame, TheBedsCornerIsExactToThePixel) {
    const Snapshot snapshot = plateau(0, 39, 0, 24);
    const View view = map_of_heights();
    const MapFrame frame = map_frame(view, snapshot, "output.world_files");
    const Image image = picture(view, snapshot);
    const auto background = colour_at(image, 0.0, 0.5);
    int first = 0;
    while (colour_at(image, (first + 0.5) / image.width, 0.5) == background) ++first;
    int top = 0;
    while (colour_at(image, 0.5, (top + 0.5) / image.height) == background) ++top;
    EXPECT_NEAR(frame.west + first * frame.pixel_x, 500000.0, frame.pixel_x);
    EXPECT_NEAR(frame.north - top * frame.pixel_y, 4400250.0, frame.pixel_y);
}

TEST(MapFrame, DegreesHavePixelsOfTheirOwnAlongBothAxes) {
    Snapshot snapshot = plateau(3, 5, 3, 5);
    snapshot.scale.place = GeoReference{15.0, 67.0, 2e-4, 1e-4, true, ""};
    const MapFrame frame = map_frame(map_of_heights(), snapshot, "output.world_files");
    EXPECT_NEAR(frame.pixel_x / frame.pixel_y, 2.0, 1e-9);
    EXPECT_LT(frame.west, 15.0);
    EXPECT_GT(frame.north, 67.0 + 25 * 1e-4);
}

TEST(MapFrame, NeedsAMap) {
    View view = map_of_heights();
    EXPECT_THROW(map_frame(view, flat_bed(9, 9), "output.world_files"), KeyError);
    view.camera.projection = Projection::perspective;
    EXPECT_THROW(map_frame(view, plateau(1, 2, 1, 2), "output.world_files"), KeyError);
}

TEST(WorldFiles, SayTheCentreOfTheFirstPixelAndTheReferenceSystem) {
    const auto files = world_files({100.0, 900.0, 2.0, 4.0, "A[\"<&>\"]"});
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].ending, ".pgw");
    EXPECT_EQ(files[0].text, "2\n0\n0\n-4\n101\n898\n");
    EXPECT_EQ(files[1].ending, ".png.aux.xml");
    EXPECT_NE(files[1].text.find("<SRS>A[\"&lt;&amp;&gt;\"]</SRS>"), std::string::npos);
    EXPECT_NE(files[1].text.find("<GeoTransform>100, 2, 0, 900, 0, -4</GeoTransform>"),
              std::string::npos);
}

}  // namespace
}  // namespace fumon
