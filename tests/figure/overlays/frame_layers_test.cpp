#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

/// A scene that looks straight down on a bed of 60 × 40 cells: 600 × 400 pixels, ten to a cell.
Scene map_scene(const std::string& overlays = "") {
    Scene scene = scene_of(overlays, 600, 400, "ground = \"table\"\nexaggeration = 1.0");
    scene.view.camera = {};
    scene.view.camera.projection = Projection::map;
    scene.view.camera.margin = 0.0;
    return scene;
}

LayerFeature line_of(std::vector<BedPlace> places, const std::string& label = "") {
    LayerFeature feature;
    feature.label = label;
    feature.anchor = places[places.size() / 2];
    feature.lines = {std::move(places)};
    return feature;
}

void lay(Scene& scene, std::vector<LayerFeature> features) {
    scene.view.layers.resize(1);
    scene.view.layers[0].colour = "#ff0000";
    PlacedLayers placed;
    placed.layers = {{std::move(features)}};
    scene.view.placed_layers = std::make_shared<const PlacedLayers>(std::move(placed));
}

Image drawn(const Scene& scene, const Snapshot& bed, const OverlayStyle& style = {},
            const Camera* camera = nullptr) {
    FrameOverlays overlays(scene, bed, style);
    const MeasuredRows rows = rows_up_to(1);
    Image image =
        grey(static_cast<int>(scene.view.image.width), static_cast<int>(scene.view.image.height));
    overlays.draw(image, {bed, rows, {0.0, 1.0}, camera});
    return image;
}

bool is_red(const Image& image, int x, int y) {
    const std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
    return pixel[0] > pixel[1] + 60 && pixel[0] > pixel[2] + 60;
}

int red_pixels(const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) count += is_red(image, x, y) ? 1 : 0;
    }
    return count;
}

std::vector<BedPlace> straight(const BedPlace& from, const BedPlace& to, int steps) {
    std::vector<BedPlace> places;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        places.push_back(
            {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])});
    }
    return places;
}

TEST(FrameLayers, PutALineWhereItLiesSeenFromAbove) {
    Scene scene = map_scene();
    lay(scene, {line_of(straight({0.25, 0.1}, {0.25, 0.9}, 40)),
                line_of(straight({0.5, 0.75}, {0.9, 0.75}, 40))});
    const Image image = drawn(scene, overlay_bed(60, 40, 0.0));
    // East 0.25 is the edge between columns 149 and 150, which a line of two pixels fills.
    for (const int y : {50, 200, 350}) {
        EXPECT_TRUE(is_red(image, 149, y)) << y;
        EXPECT_TRUE(is_red(image, 150, y)) << y;
        EXPECT_FALSE(is_red(image, 147, y)) << y;
        EXPECT_FALSE(is_red(image, 152, y)) << y;
    }
    EXPECT_FALSE(is_red(image, 150, 30));  // north of its end
    EXPECT_FALSE(is_red(image, 150, 370));
    EXPECT_TRUE(is_red(image, 400, 99));  // north 0.75: rows 99 and 100
    EXPECT_TRUE(is_red(image, 400, 100));
    EXPECT_FALSE(is_red(image, 400, 102));
}

TEST(FrameLayers, GiveALineOfMetresItsWidthOnTheGround) {
    Scene scene = map_scene();
    lay(scene, {line_of(straight({0.1, 0.5}, {0.9, 0.5}, 48))});
    const Snapshot bed = overlay_bed(60, 40, 0.0);
    scene.view.layers[0].ground_width = 2.0 * bed.scale.dy;  // two cells: 20 pixels
    const Image image = drawn(scene, bed);
    int red = 0;
    for (int y = 0; y < image.height; ++y) red += is_red(image, 300, y) ? 1 : 0;
    EXPECT_NEAR(red, 20, 1);
}

/// A wall across the middle of the bed hides what lies behind it from a camera in the south.
TEST(FrameLayers, HideWhatLiesBehindARidge) {
    Snapshot bed = overlay_bed(60, 40, 0.0);
    for (int x = 0; x < 60; ++x)
        for (int y = 18; y < 22; ++y) bed.bed(x, y) = 12.0;
    Scene scene = scene_of("", 600, 400, "ground = \"table\"\nexaggeration = 1.0");
    scene.view.camera = {};
    scene.view.camera.azimuth = 180.0;
    scene.view.camera.elevation = 20.0;
    lay(scene, {line_of(straight({0.2, 0.6}, {0.8, 0.6}, 40))});
    EXPECT_EQ(red_pixels(drawn(scene, bed)), 0);
    scene.view.layers[0].hidden = BehindRidges::show;
    const int shown = red_pixels(drawn(scene, bed));
    EXPECT_GT(shown, 200);
    scene.view.layers[0].hidden = BehindRidges::hide;
    lay(scene, {line_of(straight({0.2, 0.2}, {0.8, 0.2}, 40))});
    EXPECT_GT(red_pixels(drawn(scene, bed)), 200);
}

TEST(FrameLayers, EndWhereCellsHaveNoData) {
    Snapshot bed = overlay_bed(60, 40, 0.0);
    bed.nodata = Mask(60, 40, 0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 30; x < 60; ++x) {
            bed.nodata(x, y) = 1;
            bed.bed(x, y) = 0.0;
        }
    }
    Scene scene = map_scene();
    lay(scene, {line_of(straight({0.55, 0.5}, {0.9, 0.5}, 21))});
    EXPECT_EQ(red_pixels(drawn(scene, bed)), 0);
    lay(scene, {line_of(straight({0.1, 0.5}, {0.5, 0.5}, 24))});
    const int with_data = red_pixels(drawn(scene, bed));
    EXPECT_GT(with_data, 400);
    lay(scene, {line_of(straight({0.1, 0.5}, {0.9, 0.5}, 48))});
    EXPECT_NEAR(red_pixels(drawn(scene, bed)), with_data, 6);
}

TEST(FrameLayers, KeepLabelsApart) {
    Scene scene = map_scene();
    LayerFeature one;
    one.shape = LayerShape::points;
    one.lines = {{{0.5, 0.5}}};
    one.anchor = BedPlace{0.5, 0.5};
    one.label = "Alpha";
    LayerFeature other = one;
    other.label = "Beta";
    lay(scene, {one});
    scene.view.layers[0].marker = LayerMarker::none;
    const Snapshot bed = overlay_bed(60, 40, 0.0);
    const Image alone = drawn(scene, bed);
    lay(scene, {one, other});
    scene.view.layers[0].marker = LayerMarker::none;
    const Image both = drawn(scene, bed);
    const auto differs = [&](const Image& a, const Image& b, int left, int right) {
        int count = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = left; x < right; ++x) count += a.row(y)[3 * x] != b.row(y)[3 * x] ? 1 : 0;
        return count;
    };
    // The first keeps the place at the right of the point; the other one takes the left.
    EXPECT_EQ(differs(alone, both, 305, 600), 0);
    EXPECT_GT(differs(alone, both, 0, 295), 20);
    // Where the camera moves, each has the one place, and the second gives way.
    const Image moving = drawn(scene, bed, {false, true, 0.0});
    EXPECT_EQ(differs(alone, moving, 0, 600), 0);
}

TEST(FrameLayers, HaveALegendOfThoseThatAskForIt) {
    Scene scene = map_scene(overlay("legend", "lower-left"));
    lay(scene, {line_of(straight({0.25, 0.1}, {0.25, 0.9}, 40))});
    const Snapshot bed = overlay_bed(60, 40, 0.0);
    try {
        drawn(scene, bed);
        ADD_FAILURE();
    } catch (const KeyError& refusal) {
        EXPECT_EQ(refusal.key(), "overlay.0.kind");
    }
    scene.view.layers[0].legend = "path";
    FrameOverlays overlays(scene, bed);
    ASSERT_EQ(overlays.placed().size(), 1U);
    const CanvasBox box = overlays.placed()[0].box;
    const Image image = drawn(scene, bed);
    int red = 0;
    for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y)
        for (int x = static_cast<int>(box.x); x < static_cast<int>(box.right()); ++x)
            red += is_red(image, x, y) ? 1 : 0;
    EXPECT_GT(red, 10);  // the sign of its line
}

}  // namespace
}  // namespace fumon
