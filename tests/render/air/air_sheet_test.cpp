#include "render/air/air_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/air/air_layer.h"
#include "render/renderer.h"
#include "render/view/shown_snapshot.h"
#include "support/drawn_picture.h"
#include "support/section_beds.h"

namespace fumon {
namespace {

/// With as much of the section left as `keep` leaves of a copy.
template <class Keep>
Snapshot with_section(Snapshot snapshot, Keep keep) {
    auto section = std::make_shared<SnapshotSection>(*snapshot.section);
    keep(*section);
    snapshot.section = section;
    return snapshot;
}

void still_and_empty(SnapshotSection& section) {
    section.paths.clear();
    section.fields[0].name = "unknown";
}

struct Changed {
    int pixels = 0;
    int inside_hull = 0;
};

/// Pixels that differ, and those among them inside the quadrangle of the four corners.
Changed changed(const Image& a, const Image& b, const std::array<glm::dvec2, 4>& hull) {
    Changed result;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (std::equal(a.row(y) + 3 * x, a.row(y) + 3 * x + 3, b.row(y) + 3 * x)) continue;
            ++result.pixels;
            bool inside = true;
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec2 edge = hull[(i + 1) % 4] - hull[i];
                const glm::dvec2 to(x + 0.5 - hull[i].x, y + 0.5 - hull[i].y);
                inside = inside && edge.x * to.y - edge.y * to.x < 2.0 * glm::length(edge);
            }
            if (inside) ++result.inside_hull;
        }
    }
    return result;
}

TEST(AirSheet, ChangesPixelsOnlyAboveTheFarEdge) {
    const View view = small_view();
    const Snapshot air = with_section(eddy_section(), [](SnapshotSection& s) { s.paths.clear(); });
    const Snapshot empty = with_section(air, still_and_empty);
    const Snapshot strip = *shown_snapshot(air, view);
    const Block block = frame_block(strip, automatic_exaggeration(strip));
    const Camera camera = place_camera(view.camera, block, 320.0 / 180.0, 0.0);
    const auto corner = [&](double east, double z) {
        const glm::dvec2 at = project(camera, {east * block.width_x, 0.5 * block.width_y, z});
        return glm::dvec2(160.0 * (1.0 + at.x), 90.0 * (1.0 - at.y));
    };
    const double low = block.z(0.0);
    const double high = block.z(0.3);
    const Changed sheet =
        changed(picture(view, air), picture(view, empty),
                {corner(-0.5, low), corner(0.5, low), corner(0.5, high), corner(-0.5, high)});
    EXPECT_GT(sheet.pixels, 3000);
    EXPECT_EQ(sheet.pixels, sheet.inside_hull);
}

TEST(AirSheet, PaintsFasterAirHigherInThePalette) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    EXPECT_LT(air_palette_share(1.0, 3.0), air_palette_share(2.0, 3.0));
    EXPECT_LE(air_palette_share(3.0, 3.0), 1.0);
    EXPECT_DOUBLE_EQ(air_palette_share(1.0, 0.0), air_palette_share(0.0, 3.0)) << "still air";
    Palette palette;
    for (std::size_t i = 0; i < palette.size(); ++i)
        palette[i] = {static_cast<std::uint8_t>(i), 0, 0};
    WorkerPool pool(2);
    const AirSheet sheet = paint_air_sheet(air, palette, 400, 0.0, 1.0, pool);
    const auto texel = [&](double x, double z) {  // without streamlines: no green
        const auto row = static_cast<int>(z / sheet.high * sheet.height);
        for (auto column = static_cast<int>(x * sheet.width);; ++column) {
            const std::uint8_t* at =
                &sheet.rgba[4 * static_cast<std::size_t>(row * sheet.width + column)];
            if (at[1] == 0) return std::array<int, 2>{at[0], at[3]};
        }
    };
    EXPECT_GT(texel(0.1, 0.2)[0], texel(0.1, 0.1)[0] + 10);
    EXPECT_GT(texel(0.1, 0.1)[1], texel(0.1, 0.28)[1] + 50) << "thinner towards the top";
}

TEST(AirSheet, ShowsTheGrainsPathsAboveTheStrip) {
    const View view = small_view();
    const Snapshot with = eddy_section();
    const Snapshot without = with_section(with, [](SnapshotSection& s) { s.paths.clear(); });
    EXPECT_NE(picture(view, with), picture(view, without));

    const Snapshot strip = *shown_snapshot(with, view);
    const Block block = frame_block(strip, 1.0);
    const Camera camera = place_camera(view.camera, block, 320.0 / 180.0, 0.0);
    const auto span = [&](const Snapshot& snapshot) {
        float low = 1.0F;
        float high = -1.0F;
        for (const AirVertex& vertex : grain_paths(snapshot, block, camera)) {
            low = std::min(low, vertex.point.x);
            high = std::max(high, vertex.point.x);
        }
        return std::pair(low, high);
    };
    EXPECT_NEAR(span(strip).first, 0.1 - 0.5, 0.02);
    EXPECT_NEAR(span(strip).second, 0.85 - 0.5, 0.02);
    const Snapshot beyond = with_section(strip, [](SnapshotSection& s) {
        for (GrainPath& path : s.paths) {
            for (double& x : path.x) x += 7.0;
        }
    });
    EXPECT_NEAR(span(beyond).first, span(strip).first, 1e-5) << "seven periods on";
    EXPECT_NEAR(span(beyond).second, span(strip).second, 1e-5);
}

TEST(AirSheet, IsTheSameForAnyNumberOfThreadsAndTiles) {
    View view = small_view();
    const Snapshot snapshot = eddy_section();
    const Image expected = picture(view, snapshot, 1);
    EXPECT_EQ(picture(view, snapshot, 3), expected);
    for (const char* raster_threads : {"0", "2"}) {
        setenv("LP_NUM_THREADS", raster_threads, 1);
        EXPECT_EQ(picture(view, snapshot), expected) << raster_threads;
    }
    unsetenv("LP_NUM_THREADS");
    const Image tiled = picture(view, snapshot, 2, gl::Backend::automatic, {256});
    int beyond_rounding = 0;
    for (std::size_t i = 0; i < tiled.rgb.size(); ++i)
        beyond_rounding += std::abs(int{tiled.rgb[i]} - int{expected.rgb[i]}) > 2 ? 1 : 0;
    EXPECT_LE(beyond_rounding, 20);  // of single edge pixels, see TilesLeaveNoSeams
}

TEST(AirSheet, LeavesTheStripAsItWasWhereItIsNotAskedFor) {
    const Snapshot with = eddy_section();
    Snapshot without = with;
    without.section.reset();
    View view = small_view();
    view.look.air = false;
    EXPECT_EQ(picture(view, with), picture(view, without));
    view.look.air = true;
    EXPECT_NE(picture(view, with), picture(view, without));
    view.look.mode = ViewMode::figure;
    EXPECT_EQ(picture(view, with), picture(view, without));
}

TEST(AirSheet, StaysLowUnlessTheSceneSaysOtherwise) {
    const Snapshot strip = *shown_snapshot(eddy_section(), {});
    EXPECT_EQ(strip.bed.nx(), 96);
    EXPECT_EQ(strip.bed.ny(), 32);
    EXPECT_EQ(automatic_exaggeration(strip), 1.0) << "0.3 m over 1 m";
    Snapshot bare = strip;
    bare.section.reset();
    EXPECT_EQ(automatic_exaggeration(bare), 3.0) << "0.04 m of relief";
    const Block block = frame_block(strip, 2.0);
    EXPECT_NEAR(block.top, block.z(0.3), 1e-12);
}

}  // namespace
}  // namespace fumon
