// Coordinates along blocks in figures, and along the axes of their maps.

#include "figure/panels/block_coordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "figure/panels/map_panel.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

const CanvasBox whole_picture{0.0, 0.0, 600.0, 400.0};

/// A band of ground from the north-west to the south-east, without data on both sides of it.
Snapshot oblique_band() {
    Snapshot snapshot = wavy_bed(60, 60);
    snapshot.scale = {10.0, 10.0, 1.0, true, GeoReference{500000.0, 4400000.0, 10.0, 10.0}};
    snapshot.nodata = Mask(60, 60);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x)
            if (std::abs(x + y - 59) > 6) snapshot.nodata(x, y) = 1;
    }
    return snapshot;
}

ViewProjection from_the_south_west(const Snapshot& snapshot) {
    View view;
    const Block block = frame_block(snapshot, 1.0);
    return {place_camera(view.camera, block, 1.5, 0.0), block, whole_picture};
}

TEST(BlockCoordinates, StandBesideTheGroundThatIsThere) {
    const Snapshot band = oblique_band();
    const ViewProjection view = from_the_south_west(band);
    const BlockCoordinates shown = block_coordinates(view, band.scale, 600.0, 600.0);
    ASSERT_EQ(shown.axes.size(), 2U);
    for (const bool east : {true, false}) {
        const CoordinateAxis& axis = shown.axes[east ? 0 : 1];
        int seen = 0;
        for (double place = 30.0; place < 540.0; place += 30.0) {
            const auto at = axis.seen(place);
            if (!at) continue;
            ++seen;
            // On the south-western edge of the band, whose middle line is x + y = 600 m.
            const double other = 600.0 - place - 70.0;
            const CanvasPoint edge = view.at_ground(
                east ? glm::dvec2(place, other) : glm::dvec2(other, place), view.block.base);
            EXPECT_LT(std::hypot(at->x - edge.x, at->y - edge.y), 15.0) << place << east;
        }
        EXPECT_GE(seen, 14);
    }
}

TEST(BlockCoordinates, OfAWholeBlockAreThoseOfItsTwoNearEdges) {
    Snapshot whole = wavy_bed(60, 40);
    whole.scale = {10.0, 10.0, 1.0, true};
    const ViewProjection view = from_the_south_west(whole);
    const BlockCoordinates shown = block_coordinates(view, whole.scale, 600.0, 400.0);
    EXPECT_EQ(shown.lines.size(), 2U);
    for (const double place : {0.0, 200.0, 390.0}) {
        const CanvasPoint south = view.at_ground({place, 0.0}, view.block.base);
        const CanvasPoint west = view.at_ground({0.0, place}, view.block.base);
        const auto east_axis = shown.axes[0].seen(place);
        const auto north_axis = shown.axes[1].seen(place);
        ASSERT_TRUE(east_axis && north_axis);
        EXPECT_NEAR(east_axis->x, south.x, 1e-6);
        EXPECT_NEAR(east_axis->y, south.y, 1e-6);
        EXPECT_NEAR(north_axis->x, west.x, 1e-6);
        EXPECT_NEAR(north_axis->y, west.y, 1e-6);
        EXPECT_GT(shown.axes[0].outward(place).y, 0.0) << "down, away from the block";
    }
}

TEST(Hull, LeavesOutWhatLiesWithin) {
    const std::vector<glm::dvec2> hull = hull_of(
        {{0.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}, {1.0, 0.5}, {2.0, 2.0}, {0.0, 2.0}, {0.0, 1.0}});
    EXPECT_EQ(hull, (std::vector<glm::dvec2>{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}));
}

/// The texts of a map's panel with the coordinates of a place.
std::vector<std::string> texts_of_map(const WorldScale& scale) {
    Snapshot snapshot = wavy_bed(40, 30);
    snapshot.scale = scale;
    LookSettings look;
    look.colour_by = Colouring::height;
    MapPanelSettings settings;
    settings.colour_bar = BarPosition::none;
    settings.coordinates = scale;
    const MapPanel panel(map_picture(look, snapshot, snapshot), settings);
    Canvas canvas(500, 400, 12.0);
    panel.draw(canvas, {80.0, 20.0, 400.0, 300.0});
    std::vector<std::string> texts;
    for (const PlacedText& text : canvas.texts()) texts.push_back(text.text);
    return texts;
}

TEST(MapCoordinates, AreThoseOfTheFile) {
    const auto has = [](const std::vector<std::string>& texts, const char* text) {
        return std::ranges::find(texts, text) != texts.end();
    };
    const auto metres =
        texts_of_map({30.0, 30.0, 1.0, true, GeoReference{475900.0, 4428000.0, 30.0, 30.0}});
    EXPECT_TRUE(has(metres, "easting (km)"));
    EXPECT_TRUE(has(metres, "northing (km)")) << "900 m of 4428 km";
    EXPECT_TRUE(has(metres, "476.0"));
    EXPECT_TRUE(has(metres, "4428.2"));
    const auto degrees =
        texts_of_map({80.0, 90.0, 1.0, true, GeoReference{-105.5, 40.0, 0.01, 0.01, true}});
    EXPECT_TRUE(has(degrees, "longitude (°)"));
    EXPECT_TRUE(has(degrees, "−105.4"));
    EXPECT_TRUE(has(degrees, "40.20") || has(degrees, "40.2"));
    const auto nowhere = texts_of_map({0.5, 0.5, 1.0, true});
    EXPECT_TRUE(has(nowhere, "x (m)"));
    EXPECT_TRUE(has(nowhere, "10"));
}

}  // namespace
}  // namespace fumon
