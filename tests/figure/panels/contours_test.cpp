#include "figure/panels/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

TEST(ContourLabels, HaveTheDecimalsOfTheInterval) {
    EXPECT_EQ(contour_label(2500.0, 100.0), "2500");
    EXPECT_EQ(contour_label(0.3, 0.1), "0.3");
    EXPECT_EQ(contour_label(-0.25, 0.05), "−0.25");
    EXPECT_EQ(contour_label(-1e-17, 0.5), "0");
    EXPECT_EQ(contour_label(7.5, 2.5), "7.5");
    EXPECT_TRUE(is_index_contour(2500.0, 100.0));
    EXPECT_TRUE(is_index_contour(0.0, 0.1));
    EXPECT_FALSE(is_index_contour(0.3, 0.1));
}

/// A plane that rises eastward by 1 a cell, in metres of 10 m each.
Snapshot ramp(int nx, int ny) {
    Snapshot snapshot = overlay_bed(nx, ny, 0.0);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) snapshot.bed(x, y) = x;
    }
    snapshot.scale.in_metres = true;
    snapshot.scale.height_unit = 10.0;
    return snapshot;
}

TEST(GroundContours, StandAtWholeMultiplesOfMetresAndReachTheEdges) {
    const Snapshot bed = ramp(41, 20);
    const auto contours = ground_contours({"", 100.0}, bed);
    ASSERT_TRUE(contours);
    ASSERT_EQ(contours->lines.size(), 4U);  // 100, 200, 300, 400 m; 0 is the lowest ground itself
    for (std::size_t i = 0; i < 4; ++i) {
        const ContourLine& line = contours->lines[i];
        EXPECT_DOUBLE_EQ(line.level, 100.0 * static_cast<double>(i + 1));
        EXPECT_NEAR(line.points.front().x, 10.0 * static_cast<double>(i + 1), 1e-9);
        EXPECT_NEAR(std::abs(line.points.front().y - line.points.back().y), 20.0, 1e-9);
    }
    EXPECT_FALSE(ground_contours({"none", 0.0}, bed));
    Snapshot level = bed;
    std::ranges::fill(level.bed.values(), 7.0);
    EXPECT_FALSE(ground_contours({"auto", 0.0}, level));
    EXPECT_THROW((void)ground_contours({"", 0.1}, bed), InputError);
}

TEST(DrawnContours, WriteTheHeightsOfThickLinesIntoGapsOfThem) {
    const auto drawn = [](double level) {
        Canvas canvas(400, 200, 20.0);
        const std::vector<CanvasContour> lines{{level, {{10.0, 100.0}, {390.0, 100.0}}}};
        const std::vector<CanvasBox> taken =
            draw_contours(canvas, {0.0, 0.0, 400.0, 200.0}, lines, 1.0);
        EXPECT_EQ(taken.size(), canvas.texts().size()) << "others keep away from labels";
        return std::pair(canvas.texts().size(), canvas.image());
    };
    const auto [thin_texts, thin] = drawn(4.0);
    const auto [thick_texts, thick] = drawn(5.0);
    EXPECT_EQ(thin_texts, 0U);
    EXPECT_EQ(thick_texts, 1U);
    const auto drawn_columns = [](const Image& image) {
        int count = 0;
        for (int x = 0; x < image.width; ++x) {
            if (image.row(99)[3 * x] < 200 || image.row(100)[3 * x] < 200) ++count;
        }
        return count;
    };
    EXPECT_GT(drawn_columns(thin), 375);
    EXPECT_LT(drawn_columns(thick), 372);  // the gap of 2 × 7 pixels and the digit
    EXPECT_GT(drawn_columns(thick), 340);
}

/// A wall across the bed, and a small hill behind it as seen from the south.
Snapshot walled(bool wall, bool hill) {
    Snapshot bed = overlay_bed(64, 64, 0.0);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double away = std::hypot(x - 32.0, y - 50.0);
            const double low = hill ? std::max(0.0, 4.0 - 0.5 * away) : 0.0;
            bed.bed(x, y) = wall && y >= 14 && y <= 18 ? 12.0 : low;
        }
    }
    return bed;
}

TEST(FrameContours, AreDrawnWhereTheCameraSeesTheirGround) {
    const auto drawn = [&](const Snapshot& bed, const char* projection) {
        Scene scene = scene_of("", 640, 360,
                               "contours = 1.5\nground = \"table\"\n[camera]\nazimuth = 180\n"
                               "elevation = 5\nprojection = \"" +
                                   std::string(projection) + "\"");
        FrameOverlays over(scene, bed);
        Image image = grey(640, 360);
        over.draw(image, {bed, rows_up_to(1), {0.0, 1.0}});
        return image.rgb;
    };
    const auto nothing = grey(640, 360).rgb;
    EXPECT_NE(drawn(walled(false, true), "perspective"), nothing);
    EXPECT_EQ(drawn(walled(true, true), "perspective"), drawn(walled(true, false), "perspective"));
    EXPECT_NE(drawn(walled(true, true), "map"), drawn(walled(true, false), "map"));
}

}  // namespace
}  // namespace fumon
