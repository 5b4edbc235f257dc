#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>

#include "base/error.h"
#include "figure/canvas/canvas_box.h"
#include "figure/overlays/frame_overlays.h"
#include "render/view/framing.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

TEST(FrameOverlays, OverATransparentPictureLettersStandAlone) {
    const Scene scene = scene_of(overlay("title", "upper-left"), 400, 200);
    const Snapshot bed = overlay_bed(40, 30, 0.0);
    FrameOverlays overlays(scene, bed);
    Image open = with_alpha(grey(400, 200));
    std::fill(open.alpha.begin(), open.alpha.end(), std::uint8_t{0});
    Image white = grey(400, 200, 255);
    const MeasuredRows rows = rows_up_to(1);
    overlays.draw(open, {bed, rows});
    overlays.draw(white, {bed, rows});
    int off = 0;
    const Image laid = composited_on(open, 255);
    for (std::size_t i = 0; i < laid.rgb.size(); ++i)
        off = std::max(off, std::abs(laid.rgb[i] - white.rgb[i]));
    EXPECT_LE(off, 2);
    EXPECT_EQ(open.alpha.back(), 0);
}

TEST(InsetMapOverlay, StaysInPlaceWhileTheCameraWanders) {
    const Scene scene =
        scene_of(overlay("inset-map", "lower-right", "size = 0.4"), 640, 360, "ground = \"table\"");
    const Snapshot bed = overlay_bed(60, 40, 0.0);
    FrameOverlays overlays(scene, bed, {false, true, 0.0});
    const MeasuredRows rows = rows_up_to(1);
    const Block block = framed_block(scene.view, bed);
    const CanvasBox box = overlays.placed().front().box;
    const auto drawn_from = [&](double azimuth) {
        CameraSettings settings = scene.view.camera;
        settings.azimuth = azimuth;
        const Camera camera = place_camera(settings, block, 640.0 / 360.0, 0.0);
        Image image = grey(640, 360);
        overlays.draw(image, {bed, rows, {0.0, 1.0}, &camera});
        return image;
    };
    /// The mean place of the camera's red.
    const auto red_of = [&](const Image& image) {
        double count = 0.0;
        glm::dvec2 sum(0.0);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
                if (pixel[0] < pixel[1] + 90) continue;
                sum += glm::dvec2(x, y);
                count += 1.0;
            }
        }
        return sum / std::max(count, 1.0);
    };
    const double middle_x = box.x + 0.5 * box.width;
    const double middle_y = box.y + 0.5 * box.height;
    const Image south = drawn_from(180.0);
    EXPECT_EQ(overlays.placed().front().box.x, box.x);
    EXPECT_GT(red_of(south).y, middle_y + 0.2 * box.height);
    EXPECT_LT(red_of(drawn_from(0.0)).y, middle_y - 0.2 * box.height);
    EXPECT_GT(red_of(drawn_from(90.0)).x, middle_x + 0.2 * box.width);
    EXPECT_LT(red_of(drawn_from(270.0)).x, middle_x - 0.2 * box.width);
    const Image from_above = grey(640, 360);
    int outside = 0;
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 640; ++x)
            if (x < box.x || y < box.y || x >= box.right() || y >= box.bottom())
                outside += south.row(y)[3 * x] != from_above.row(y)[3 * x] ? 1 : 0;
    EXPECT_EQ(outside, 0);
    const Scene map =
        scene_of(overlay("inset-map", "lower-right"), 640, 360, "[camera]\nprojection = \"map\"\n");
    EXPECT_THROW(FrameOverlays(map, bed), KeyError);
}

TEST(InsetMapOverlay, ShadesAnEvenSlopeEvenly) {
    const Scene scene = scene_of(overlay("inset-map", "lower-right", "size = 0.4\nopacity = 1"),
                                 640, 360, "ground = \"table\"");
    for (const int cells : {60, 131, 250}) {  // 144 pixels across
        Snapshot bed = overlay_bed(cells, cells, 0.0);
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) bed.bed(x, y) = 0.2 * (x + y);
        FrameOverlays overlays(scene, bed, {false, true, 0.0});
        CameraSettings settings = scene.view.camera;
        settings.azimuth = 180.0;
        const Camera camera =
            place_camera(settings, framed_block(scene.view, bed), 640.0 / 360.0, 0.0);
        const MeasuredRows rows = rows_up_to(1);
        Image image = grey(640, 360);
        overlays.draw(image, {bed, rows, {0.0, 1.0}, &camera});
        const CanvasBox box = overlays.placed().front().box;
        int least = 255;
        int most = 0;
        for (int y = 0; y < 30; ++y) {  // the map's northern part, within its outline
            for (int x = 0; x < 80; ++x) {
                const int row = static_cast<int>(box.y + 0.35 * box.height) + y;
                const int column = static_cast<int>(box.x + 0.5 * box.width) - 40 + x;
                const int level = image.row(row)[std::ptrdiff_t{3} * column];
                least = std::min(least, level);
                most = std::max(most, level);
            }
        }
        EXPECT_LE(most - least, 2) << cells;
    }
}

TEST(ArrowOverlay, ShowsAllWindsThatCancelAndTheOneThatBlows) {
    const Scene scene = scene_of(overlay("arrow", "upper-right", "font_size = 24"), 640, 360,
                                 "ground = \"table\"\n[camera]\nprojection = \"map\"\n");
    Snapshot bed = overlay_bed(60, 40, 0.0);
    const CanvasBox compass_alone = [&] {
        bed.winds = {{1.0, 0.0, 1.0}, {-1.0, 0.0, 1.0}};
        const FrameOverlays two(scene, bed);
        return two.placed().front().box;
    }();
    bed.winds = {{1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}, {-1.0, 0.0, 1.0}, {0.0, -1.0, 1.0}};
    FrameOverlays overlays(scene, bed);
    const CanvasBox box = overlays.placed().front().box;
    EXPECT_GT(box.height, compass_alone.height) << "as high as it is wide";
    const MeasuredRows rows = rows_up_to(1);
    /// The middle of what is dark in the rose, in shares of the overlay's height.
    const auto dark = [&](double from) {
        bed.numbers = {{"wind_from", "degrees", from}};
        Image image = grey(640, 360);
        overlays.draw(image, {bed, rows});
        const double side = box.height;
        double count = 0.0;
        glm::dvec2 sum(0.0);
        for (int y = 0; y < static_cast<int>(side); ++y) {
            for (int x = 0; x < static_cast<int>(side); ++x) {
                const int column = static_cast<int>(box.x) + x;
                if (image.row(static_cast<int>(box.y) + y)[std::ptrdiff_t{3} * column] > 60)
                    continue;
                sum += glm::dvec2(x, y) / side;
                count += 1.0;
            }
        }
        return sum / std::max(count, 1.0);
    };
    EXPECT_LT(dark(270.0).x, 0.4);  // a wind from the west, left of the middle
    EXPECT_GT(dark(90.0).x, 0.6);
    EXPECT_LT(dark(0.0).y, 0.4);
    EXPECT_GT(dark(180.0).y, 0.6);
    EXPECT_NEAR(dark(0.0).x, 0.5, 0.05);
}

}  // namespace
}  // namespace fumon
