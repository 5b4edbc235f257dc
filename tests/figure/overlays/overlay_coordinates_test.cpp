// Coordinates along maps and blocks: their numbers, and that no text leaves the picture or meets
// another.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/overlays/overlay.h"
#include "figure/plot/coordinate_scale.h"
#include "render/view/camera.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

using Labels = std::vector<std::string>;

WorldScale placed(GeoReference place, double dx, double dy) {
    return {dx, dy, 1.0, true, std::move(place)};
}

TEST(CoordinateScale, MarksStandAtRoundCoordinatesOfTheFile) {
    const WorldScale utm = placed({475900.0, 4428000.0, 30.0, 30.0}, 30.0, 30.0);
    const CoordinateScale east(utm, CoordinateScale::Axis::east);
    const Ticks ticks = east.ticks(3000.0, 4);
    EXPECT_EQ(ticks.labels, (Labels{"476 km E", "477 km E", "478 km E"}));
    EXPECT_DOUBLE_EQ(east.place_of(ticks.values[0]), 100.0);
    EXPECT_DOUBLE_EQ(east.coordinate_at(100.0), 476000.0);
    EXPECT_EQ(CoordinateScale(utm, CoordinateScale::Axis::north).ticks(1200.0, 4).labels,
              (Labels{"4428.0 km N", "4428.5 km N", "4429.0 km N"}));
    EXPECT_EQ(east.ticks(130.0, 3).labels, (Labels{"475900 m E", "475950 m E", "476000 m E"}));
}

TEST(CoordinateScale, DegreesSayTheirSides) {
    const WorldScale scale = placed({-0.01, -0.004, 0.001, 0.001, true}, 111.0, 110.0);
    EXPECT_EQ(CoordinateScale(scale, CoordinateScale::Axis::east).ticks(2220.0, 5).labels,
              (Labels{"0.010° W", "0.005° W", "0.000°", "0.005° E", "0.010° E"}));
    EXPECT_EQ(CoordinateScale(scale, CoordinateScale::Axis::north).ticks(880.0, 5).labels,
              (Labels{"0.004° S", "0.002° S", "0.000°", "0.002° N", "0.004° N"}));
    const WorldScale turned = placed({254.4, 40.0, 0.1, 0.1, true}, 8000.0, 11000.0);
    EXPECT_EQ(CoordinateScale(turned, CoordinateScale::Axis::east).ticks(16000.0, 3).labels,
              (Labels{"105.6° W", "105.5° W", "105.4° W"}));
}

TEST(CoordinateScale, FeetAreFeetAndCellsOfAStretchedProjectionCountAsTheFileHasThem) {
    GeoReference feet{1000.0, 2000.0, 10.0, 10.0};
    feet.crs = R"(PROJCS["x",GEOGCS["y"],PROJECTION["Lambert_Conformal_Conic_2SP"],)"
               R"(UNIT["US survey foot",0.304800609601219]])";
    const WorldScale scale = placed(feet, 3.0480061, 3.0480061);
    EXPECT_EQ(CoordinateScale(scale, CoordinateScale::Axis::east).ticks(61.0, 3).labels,
              (Labels{"1000 ft E", "1100 ft E", "1200 ft E"}));
    const WorldScale mercator = placed({0.0, 0.0, 10.0, 10.0}, 7.7, 7.7);
    EXPECT_NEAR(CoordinateScale(mercator, CoordinateScale::Axis::east).coordinate_at(77.0), 100.0,
                1e-9);
}

TEST(CoordinateScale, WithoutAPlaceMetresOrSitesCountFromTheCorner) {
    const CoordinateScale metres({2.0, 2.0, 1.0, true}, CoordinateScale::Axis::north);
    EXPECT_EQ(metres.ticks(100.0, 3).labels, (Labels{"0 m", "50 m", "100 m"}));
    EXPECT_EQ(metres.ticks(3000.0, 4).labels, (Labels{"0 km", "1 km", "2 km", "3 km"}));
    EXPECT_EQ(CoordinateScale({}, CoordinateScale::Axis::east).ticks(40.0, 3).labels,
              (Labels{"0", "20", "40"}));
}

class OverlayCoordinates : public ::testing::Test {
  protected:
    OverlayCoordinates() {
        first_.scale.place = GeoReference{475900.0, 4428000.0, 5.0, 7.0};
        first_.scale.dy = 7.0;
    }

    /// The texts over a frame of that camera.
    std::vector<PlacedText> texts(const std::string& camera, int width, int height,
                                  const std::vector<CanvasBox>& taken = {}) const {
        const Scene scene =
            scene_of(overlay("coordinates", "upper-left"), width, height, "[camera]\n" + camera);
        const auto made = make_coordinates_overlay({scene, first_, first_}, 0);
        made->avoid_boxes(taken, 0.8);
        Canvas canvas(width, height, 0.012 * width, CanvasGround::transparent);
        const MeasuredRows rows;
        made->draw(canvas, {0.0, 0.0, static_cast<double>(width), static_cast<double>(height)},
                   {first_, rows});
        return canvas.texts();
    }

    static void expect_apart(const std::vector<PlacedText>& texts, int width, int height,
                             const std::string& what) {
        const CanvasBox picture{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
        for (std::size_t i = 0; i < texts.size(); ++i) {
            EXPECT_TRUE(within(texts[i].box, picture)) << what << texts[i].text;
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(overlap(texts[i].box, texts[j].box))
                    << what << texts[i].text << texts[j].text;
        }
    }

    Snapshot first_ = overlay_bed(120, 90, 5.0);
};

TEST_F(OverlayCoordinates, NoTextLeavesThePictureOrMeetsAnother) {
    for (const auto& [width, height] : {std::pair{960, 540}, std::pair{300, 400}}) {
        for (const char* projection : {"perspective", "orthographic"}) {
            for (int azimuth = 0; azimuth < 360; azimuth += 15) {
                for (const int elevation : {4, 25, 60, 89}) {
                    const std::string camera =
                        fmt::format("projection = \"{}\"\nazimuth = {}\nelevation = {}\n",
                                    projection, azimuth, elevation);
                    const auto found = texts(camera, width, height);
                    EXPECT_GE(found.size(), 2U) << camera;
                    expect_apart(found, width, height, camera);
                }
            }
        }
    }
}

TEST_F(OverlayCoordinates, AMapHasItsTextsOutsideWhereThereIsRoom) {
    const auto outside = texts("projection = \"map\"\nmargin = 0.2\n", 960, 540);
    expect_apart(outside, 960, 540, "map");
    const std::array<double, 4> bed = map_rectangle(
        scene_of("", 960, 540, "[camera]\nprojection = \"map\"\nmargin = 0.2\n").view, first_);
    const CanvasBox rectangle{bed[0], bed[1], bed[2], bed[3]};
    ASSERT_GE(outside.size(), 6U);
    for (const PlacedText& text : outside) EXPECT_FALSE(overlap(text.box, rectangle)) << text.text;
    const auto inside = texts("projection = \"map\"\nmargin = 0\n", 960, 720);
    expect_apart(inside, 960, 720, "full map");
    EXPECT_GE(inside.size(), 4U);
}

TEST_F(OverlayCoordinates, AMarkOfAMapStandsAtItsCoordinate) {
    const auto found = texts("projection = \"map\"\nmargin = 0.2\n", 960, 540);
    const std::array<double, 4> bed = map_rectangle(
        scene_of("", 960, 540, "[camera]\nprojection = \"map\"\nmargin = 0.2\n").view, first_);
    int seen = 0;
    for (const PlacedText& text : found) {
        if (text.text == "476.0 km E") {
            EXPECT_NEAR(text.box.middle().x, bed[0] + bed[2] * 100.0 / 600.0, 0.5);
            ++seen;
        } else if (text.text == "4428.2 km N") {
            EXPECT_NEAR(text.box.middle().y, bed[1] + bed[3] * (1.0 - 200.0 / 630.0), 0.5);
            ++seen;
        }
    }
    EXPECT_EQ(seen, 2) << "of " << found.size();
}

TEST_F(OverlayCoordinates, TextsKeepAwayFromPlates) {
    const CanvasBox plate{0.0, 300.0, 960.0, 240.0};
    for (const PlacedText& text : texts("azimuth = 200\n", 960, 540, {plate}))
        EXPECT_FALSE(overlap(text.box, plate)) << text.text;
}

TEST_F(OverlayCoordinates, TheyStandBelowOtherOverlaysAndChangeNothingElse) {
    const std::string time = overlay("time", "upper-left");
    Scene alone = scene_of(time, 640, 360);
    Scene both = scene_of(time + overlay("coordinates", "upper-left"), 640, 360);
    FrameOverlays one(alone, first_);
    FrameOverlays two(both, first_);
    ASSERT_EQ(two.placed().size(), 1U);
    EXPECT_EQ(two.placed()[0].box.y, one.placed()[0].box.y);
    Image plain = grey(640, 360);
    Image with = grey(640, 360);
    const MeasuredRows rows = rows_up_to(20);
    one.draw(plain, {first_, rows});
    two.draw(with, {first_, rows});
    EXPECT_NE(plain.rgb, with.rgb);
    const CanvasBox& box = one.placed()[0].box;
    for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
        for (int x = static_cast<int>(box.x); x < static_cast<int>(box.right()); ++x)
            ASSERT_EQ(plain.row(y)[3 * x], with.row(y)[3 * x]);
    }
}

TEST_F(OverlayCoordinates, AProfileHasNone) {
    Snapshot profile = overlay_bed(120, 1, 5.0);
    const Scene scene = scene_of(overlay("coordinates", "upper-left"), 640, 360);
    EXPECT_THROW(FrameOverlays(scene, profile), KeyError);
}

}  // namespace
}  // namespace fumon
