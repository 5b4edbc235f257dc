#include "figure/overlays/survey_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "figure/overlays/frame_overlays.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

constexpr int nx = 60;
constexpr int ny = 40;

/// West, east, south and north, shares of the bed's sides.
std::array<double, 4> extent_of(const PlacedLayer& layer) {
    std::array<double, 4> extent{1e9, -1e9, 1e9, -1e9};
    for (const LayerFeature& feature : layer.features) {
        for (const auto& line : feature.lines) {
            for (const BedPlace& place : line) {
                extent[0] = std::min(extent[0], place[0]);
                extent[1] = std::max(extent[1], place[0]);
                extent[2] = std::min(extent[2], place[1]);
                extent[3] = std::max(extent[3], place[1]);
            }
        }
    }
    return extent;
}

TEST(SurveyEdge, IsTheOutlineOfTheCellsThatHaveData) {
    Snapshot bed = overlay_bed(nx, ny, 0.0);
    const PlacedLayer whole = survey_edge(bed);
    ASSERT_EQ(whole.features.size(), 1U);
    ASSERT_EQ(whole.features[0].lines.size(), 1U);
    const auto all = extent_of(whole);
    EXPECT_NEAR(all[0], 0.0, 0.02 / nx);
    EXPECT_NEAR(all[1], 1.0, 0.02 / nx);
    EXPECT_NEAR(all[2], 0.0, 0.02 / ny);
    EXPECT_NEAR(all[3], 1.0, 0.02 / ny);

    bed.nodata = Mask(nx, ny, 0);
    for (int y = 0; y < ny; ++y)
        for (int x = 45; x < nx; ++x) bed.nodata(x, y) = 1;
    bed.nodata(20, 20) = 1;
    const PlacedLayer masked = survey_edge(bed);
    EXPECT_EQ(masked.features[0].lines.size(), 2U) << "a hole has an edge too";
    const auto left = extent_of(masked);
    EXPECT_NEAR(left[1], 0.75, 0.02 / nx);
    for (const auto& line : masked.features[0].lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            EXPECT_LE(
                std::hypot(nx * (line[i][0] - line[i - 1][0]), ny * (line[i][1] - line[i - 1][1])),
                1.01);
            const int x = std::min(static_cast<int>(nx * line[i][0]), nx - 1);
            const int y = std::min(static_cast<int>(ny * line[i][1]), ny - 1);
            EXPECT_EQ(bed.nodata(x, y), 0) << "where the ground has a height";
        }
    }
}

/// Pixels that a look changes in a grey picture of endless ground.
int drawn_pixels(const char* look, bool periodic) {
    Scene scene = scene_of("", 600, 400, look);
    scene.view.camera = {};
    scene.view.camera.elevation = 60.0;
    scene.view.camera.distance = 3.0;
    Snapshot bed = overlay_bed(nx, ny, 0.0);
    bed.periodic = periodic;
    FrameOverlays overlays(scene, bed);
    const MeasuredRows rows = rows_up_to(1);
    const Image before = grey(600, 400);
    Image image = before;
    overlays.draw(image, {bed, rows, {0.0, 1.0}});
    int changed = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        changed += image.rgb[i] > before.rgb[i] + 60 ? 1 : 0;
    return changed;
}

TEST(SurveyEdge, IsALineOnEndlessGroundOfABedThatEnds) {
    const int line = drawn_pixels("ground = \"endless\"\nsurvey_edge = \"line\"", false);
    EXPECT_GT(line, 300);
    EXPECT_LT(line, 3000) << "thin";
    EXPECT_EQ(drawn_pixels("ground = \"endless\"", false), 0);
    EXPECT_EQ(drawn_pixels("ground = \"endless\"\nsurvey_edge = \"fade\"", false), 0);
    EXPECT_EQ(drawn_pixels("ground = \"endless\"\nsurvey_edge = \"line\"", true), 0);
    EXPECT_EQ(drawn_pixels("ground = \"table\"\nsurvey_edge = \"line\"", false), 0);
}

}  // namespace
}  // namespace fumon
