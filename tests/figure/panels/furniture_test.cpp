#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "figure/panels/axis_units.h"
#include "figure/panels/colour_bar.h"
#include "figure/panels/ground_arrow.h"
#include "figure/panels/map_panel.h"
#include "figure/panels/scale_bar.h"
#include "figure/panels/step_text.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

ViewProjection projection_of(const CameraSettings& camera, const Snapshot& snapshot) {
    const Block block = frame_block(snapshot, 1.0);
    return {place_camera(camera, block, 4.0 / 3.0, 0.0), block, {0.0, 0.0, 800.0, 600.0}};
}

/// The box around all pixels of an image that are not white.
CanvasBox dark_box(const Image& image) {
    int left = image.width, right = -1, top = image.height, bottom = -1;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.row(y)[3 * x + 1] > 128) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    return {static_cast<double>(left), static_cast<double>(top), right - left + 1.0,
            bottom - top + 1.0};
}

TEST(ScaleBar, IsRoundAndAsLongAsItSays) {
    const struct {
        bool in_metres;
        double units_per_length;
        double longest;
        double length;
        const char* text;
    } cases[]{{true, 0.5, 120.0, 200.0, "200 m"},    {true, 40.0, 100.0, 2.0, "2 m"},
              {true, 0.02, 100.0, 5000.0, "5 km"},   {true, 2e4, 110.0, 0.005, "5 mm"},
              {false, 3.0, 100.0, 20.0, "20 sites"}, {false, 60.0, 100.0, 1.0, "1 site"},
              {true, 0.1, 100.0, 1000.0, "1 km"}};
    for (const auto& one : cases) {
        const ScaleBar bar = round_scale_bar(one.in_metres, one.units_per_length, one.longest);
        EXPECT_NEAR(bar.length, one.length, 1e-9 * one.length);
        EXPECT_EQ(bar.text, one.text);
        EXPECT_NEAR(bar.drawn, one.length * one.units_per_length, 1e-6);
        EXPECT_LE(bar.drawn, one.longest * (1.0 + 1e-6));
    }
}

TEST(ScaleBar, DrawsAsManyPixelsAsItsLengthTakes) {
    for (const double scale : {0.37, 1.3, 7.0}) {
        const ScaleBar bar = round_scale_bar(true, scale, 150.0);
        Canvas canvas(300, 100, 12.0);
        const FurnitureSize size = scale_bar_size(canvas, {bar.length, bar.drawn, ""});
        draw_scale_bar(canvas, {bar.length, bar.drawn, ""}, {20.0, 30.0, size.width, size.height});
        EXPECT_NEAR(dark_box(canvas.image()).width, bar.length * scale, 1.0);
    }
}

TEST(GroundBar, EndsWhereItsGroundIsSeen) {
    Snapshot snapshot = wavy_bed(60, 40);
    snapshot.scale = {2.0, 2.0, 1.0, true};
    for (const double azimuth : {180.0, 215.0, 300.0}) {
        CameraSettings camera;
        camera.azimuth = azimuth;
        const ViewProjection view = projection_of(camera, snapshot);
        const GroundBar bar =
            ground_scale_bar(view, true, {10.0, 0.0}, {1.0, 0.0}, 70.0, view.block.base);
        EXPECT_EQ(bar.text, "50 m");
        // Each metre along it again: the projection of the place 50 m further east.
        const CanvasPoint end = view.at_ground({60.0, 0.0}, view.block.base);
        EXPECT_NEAR(bar.to.x, end.x, 1e-9);
        EXPECT_NEAR(bar.to.y, end.y, 1e-9);
        EXPECT_GT(std::hypot(bar.to.x - bar.from.x, bar.to.y - bar.from.y), 20.0);
    }
}

TEST(GroundAxes, AreThoseOfAMapSeenFromAbove) {
    CameraSettings camera;
    camera.projection = Projection::map;
    const GroundAxes axes = visible_axes(projection_of(camera, wavy_bed(60, 40)));
    EXPECT_NEAR(axes.east.x, 1.0, 1e-9);
    EXPECT_NEAR(axes.east.y, 0.0, 1e-9);
    EXPECT_NEAR(axes.north.x, 0.0, 1e-9);
    EXPECT_NEAR(axes.north.y, -1.0, 1e-9);
}

TEST(GroundAxes, PointAsTheCameraSees) {
    CameraSettings camera;
    camera.projection = Projection::orthographic;
    camera.elevation = 30.0;
    const Snapshot snapshot = wavy_bed(60, 40);
    for (double azimuth = 5.0; azimuth < 360.0; azimuth += 50.0) {
        camera.azimuth = azimuth;
        // The camera looks from `azimuth` to the opposite one: ground towards it moves down the
        // picture, shortened by the sine of 30 degrees; ground at right angles keeps its length.
        const double a = azimuth * std::numbers::pi / 180.0;
        const GroundAxes axes = visible_axes(projection_of(camera, snapshot));
        EXPECT_NEAR(axes.east.x, -std::cos(a), 1e-6) << azimuth;
        EXPECT_NEAR(axes.east.y, 0.5 * std::sin(a), 1e-6) << azimuth;
        EXPECT_NEAR(axes.north.x, std::sin(a), 1e-6) << azimuth;
        EXPECT_NEAR(axes.north.y, 0.5 * std::cos(a), 1e-6) << azimuth;
    }
}

TEST(GroundArrow, PointsTheWindsWayWithinItsBox) {
    for (const double azimuth : {180.0, 90.0, 250.0, 0.0}) {
        CameraSettings camera;
        camera.azimuth = azimuth;
        const GroundAxes axes = visible_axes(projection_of(camera, wavy_bed(60, 40)));
        Canvas canvas(200, 200, 20.0);
        const GroundDirection wind{wind_direction(Snapshot{})->towards, ""};
        const FurnitureSize size = ground_arrow_size(canvas, wind, axes);
        const CanvasBox box{60.0, 60.0, size.width, size.height};
        draw_ground_arrow(canvas, wind, axes, box);
        const Image image = canvas.image();
        const CanvasBox dark = dark_box(image);
        EXPECT_GE(dark.x, box.x - 1.0);
        EXPECT_LE(dark.x + dark.width, box.x + box.width + 1.0);
        EXPECT_GE(dark.y, box.y - 1.0);
        EXPECT_LE(dark.y + dark.height, box.y + box.height + 1.0);
        // Its head is heavier than its shaft: the ink's middle lies off the box's, that way.
        double sum = 0.0, along = 0.0;
        const glm::dvec2 seen = axes({1.0, 0.0});
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double ink = 255.0 - image.row(y)[3 * x];
                sum += ink;
                along += ink * (seen.x * (x + 0.5 - box.x - 0.5 * box.width) +
                                seen.y * (y + 0.5 - box.y - 0.5 * box.height));
            }
        }
        EXPECT_GT(along / sum, 0.05 * canvas.font_size() * glm::dot(seen, seen)) << azimuth;
    }
}

TEST(GroundArrow, KeepsItsLabelWithinItsBox) {
    Canvas canvas(300, 300, 15.0);
    for (const GroundDirection& direction : {*wind_direction(Snapshot{}), flow_direction()}) {
        const FurnitureSize size = ground_arrow_size(canvas, direction, map_axes());
        const CanvasBox box{50.0, 60.0, size.width, size.height};
        draw_ground_arrow(canvas, direction, map_axes(), box);
        const CanvasBox& text = canvas.texts().back().box;
        EXPECT_GE(text.x, box.x - 1e-6);
        EXPECT_GE(text.y, box.y - 1e-6);
        EXPECT_LE(text.x + text.width, box.x + box.width + 1e-6);
        EXPECT_LE(text.y + text.height, box.y + box.height + 1e-6);
    }
    const FurnitureSize size = compass_size(canvas, map_axes());
    draw_compass(canvas, map_axes(), {200.0, 200.0, size.width, size.height});
    EXPECT_NEAR(canvas.texts().back().box.y, 200.0, 1e-6);  // the N is up
}

TEST(ColourBar, ShowsEveryValueInItsColour) {
    ColourScale scale{read_palette("viridis"), -2.0, 3.0, ""};
    for (const auto direction : {BarDirection::upright, BarDirection::level}) {
        Canvas canvas(700, 700, 12.0);
        const bool upright = direction == BarDirection::upright;
        const CanvasBox bar =
            upright ? CanvasBox{50.0, 50.0, 20.0, 600.0} : CanvasBox{50.0, 50.0, 600.0, 20.0};
        draw_colour_bar(canvas, bar, scale, direction);
        const Image image = canvas.image();
        for (int i = 3; i < 597; ++i) {
            const double share = (i + 0.5) / 600.0;
            const int x = upright ? 60 : 50 + i;
            const int y = upright ? 649 - i : 60;
            const auto place = static_cast<int>(scale.place(-2.0 + 5.0 * share));
            int nearest = 255;  // a pixel at the border of two colours may take either
            for (int other = std::max(0, place - 1); other <= std::min(255, place + 1); ++other) {
                int off = 0;
                for (int c = 0; c < 3; ++c) {
                    off = std::max(off, std::abs(image.row(y)[3 * x + c] -
                                                 scale.palette[static_cast<std::size_t>(other)]
                                                              [static_cast<std::size_t>(c)]));
                }
                nearest = std::min(nearest, off);
            }
            EXPECT_LE(nearest, 1) << share;
        }
    }
}

TEST(ColourBar, KeepsItsTextsWithinItsMargins) {
    const ColourScale scale{read_palette("grey"), -1234.5, 98765.4, "water depth (m)"};
    for (const double length : {40.0, 90.0, 300.0}) {
        for (const auto direction : {BarDirection::upright, BarDirection::level}) {
            Canvas canvas(600, 600, 11.0);
            const bool upright = direction == BarDirection::upright;
            const CanvasBox bar{150.0, 150.0, upright ? 10.0 : length, upright ? length : 10.0};
            const PanelMargins margins = colour_bar_margins(canvas, bar, scale, direction);
            draw_colour_bar(canvas, bar, scale, direction);
            ASSERT_GE(canvas.texts().size(), 2U);
            const double slack = 0.01;  // units, since letters are placed by 1/1024
            for (const PlacedText& text : canvas.texts()) {
                EXPECT_GE(text.box.x, bar.x - margins.left - slack) << text.text;
                EXPECT_LE(text.box.x + text.box.width, bar.x + bar.width + margins.right + slack);
                EXPECT_GE(text.box.y, bar.y - margins.above - slack) << text.text;
                EXPECT_LE(text.box.y + text.box.height, bar.y + bar.height + margins.below + slack);
            }
        }
    }
}

TEST(LengthUnit, IsConvenient) {
    EXPECT_EQ(length_unit(false, 1e5).symbol, "sites");
    EXPECT_EQ(length_unit(true, 0.33).symbol, "mm");
    EXPECT_EQ(length_unit(true, 1.0).symbol, "m");
    EXPECT_EQ(length_unit(true, 9999.0).symbol, "m");
    EXPECT_EQ(length_unit(true, 1e4).symbol, "km");
}

TEST(StepText, SaysStepAndTime) {
    Snapshot snapshot;
    snapshot.step = 1200;
    snapshot.time = 1200;
    snapshot.time_unit = std::string("steps");
    EXPECT_EQ(step_text(snapshot), "step 1200");
    EXPECT_EQ(time_text(snapshot), "step 1200");
    snapshot.time_unit = std::string("s");
    EXPECT_EQ(step_text(snapshot), "step 1200, t = 20 min");
    EXPECT_EQ(time_text(snapshot), "t = 20 min");
    snapshot.time = 1000;
    EXPECT_EQ(time_text(snapshot), "t = 1000 s");
    snapshot.time = 7.5e-5;
    EXPECT_EQ(time_text(snapshot), "t = 75 µs");
    snapshot.time = 9000;
    EXPECT_EQ(time_text(snapshot), "t = 2.5 h");
}

TEST(ArrowCorner, IsWhereLeastIsHidden) {
    const auto arrow_corner = [](const Grid& values, const std::vector<Corner>& taken) {
        return fumon::arrow_corner(values, {50.0, 20.0, 80.0, 40.0}, {20.0, 10.0}, 1.0, taken);
    };
    Grid flat(40, 20, 3.0);
    EXPECT_EQ(arrow_corner(flat, {}), Corner::upper_right);
    Grid dune = flat;
    dune(38, 18) = 9.0;
    EXPECT_EQ(arrow_corner(dune, {}), Corner::upper_left);
    EXPECT_EQ(arrow_corner(dune, {Corner::upper_left}), Corner::lower_right);
    dune(1, 18) = 8.0;
    EXPECT_EQ(arrow_corner(dune, {Corner::lower_right}), Corner::lower_left);
    Grid dunes(40, 20, 0.0);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) dunes(x, y) = x % 4;
    EXPECT_EQ(arrow_corner(dunes, {}), Corner::upper_right) << "as much everywhere";
}

TEST(GroundArrow, TurnsWithTheWindsOfARun) {
    Snapshot snapshot;
    EXPECT_EQ(wind_direction(snapshot)->towards.x, 1.0);
    snapshot.winds = {{0.0, -1.0, 30.0}};
    EXPECT_EQ(wind_direction(snapshot)->towards.y, -1.0);
    EXPECT_EQ(wind_direction(snapshot)->label, "wind");
    snapshot.winds.push_back({1.0, 0.0, 40.0});
    EXPECT_NEAR(wind_direction(snapshot)->towards.x, 0.8, 1e-12);
    EXPECT_NEAR(wind_direction(snapshot)->towards.y, -0.6, 1e-12);
    EXPECT_EQ(wind_direction(snapshot)->label, "drift");
    snapshot.winds = {{1.0, 0.0, 30.0}, {-1.0, 0.0, 30.0}};
    EXPECT_FALSE(wind_direction(snapshot).has_value()) << "they cancel";
}

}  // namespace
}  // namespace fumon
