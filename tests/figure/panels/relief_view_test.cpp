// Views whose relief is to read in print: where the sun stands, how heights are exaggerated, how
// thick the block is, and its outline.

#include "figure/panels/relief_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/view/block.h"
#include "render/view/framing.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// Waves along an azimuth, 12 cells long.
Snapshot waves(double azimuth, double height) {
    Snapshot snapshot;
    snapshot.bed = Grid(60, 60);
    const double along = azimuth * std::numbers::pi / 180.0;
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x) {
            const double way = x * std::sin(along) + y * std::cos(along);
            snapshot.bed(x, y) = height * std::sin(2.0 * std::numbers::pi * way / 12.0);
        }
    }
    return snapshot;
}

Snapshot cone() {
    Snapshot snapshot;
    snapshot.bed = Grid(61, 61);
    for (int y = 0; y < 61; ++y) {
        for (int x = 0; x < 61; ++x)
            snapshot.bed(x, y) = std::max(0.0, 20.0 - std::hypot(x - 30.0, y - 30.0));
    }
    return snapshot;
}

TEST(SlopeDirection, RunsAcrossTheCrests) {
    for (const double azimuth : {0.0, 30.0, 90.0, 120.0, 165.0}) {
        const SlopeDirection slopes = slope_direction(waves(azimuth, 1.0));
        const double off = std::remainder(slopes.azimuth - azimuth, 180.0);
        EXPECT_NEAR(off, 0.0, 2.0) << azimuth;
        EXPECT_GT(slopes.coherence, 0.9);
    }
    EXPECT_LT(slope_direction(cone()).coherence, 0.05);
    EXPECT_EQ(slope_direction(waves(0.0, 0.0)).coherence, 0.0) << "even ground";
    Snapshot half = waves(90.0, 1.0);
    half.nodata = Mask(60, 60);
    for (int y = 0; y < 60; ++y) {
        for (int x = 30; x < 60; ++x) {
            half.nodata(x, y) = 1;
            half.bed(x, y) = y % 2 == 0 ? -9999.0 : 9999.0;
        }
    }
    EXPECT_NEAR(slope_direction(half).azimuth, 90.0, 2.0) << "of cells with data";
}

TEST(ReliefLight, ComesFromTheUpperLeftAndAcrossParallelCrests) {
    // Seen from the south-west, the upper left is 325 degrees.
    EXPECT_NEAR(relief_light_azimuth({0.0, 0.0}, 215.0), 325.0, 1e-9) << "no crests";
    EXPECT_NEAR(relief_light_azimuth({90.0, 1.0}, 215.0), 290.0, 1e-9) << "crests run north";
    EXPECT_NEAR(relief_light_azimuth({0.0, 1.0}, 215.0), 340.0, 1e-9) << "crests run east";
    EXPECT_NEAR(relief_light_azimuth({90.0, 1.0}, 35.0), 110.0, 1e-9) << "from the north-east";
    for (double crests = 0.0; crests < 180.0; crests += 7.0) {
        for (const double camera : {-300.0, 0.0, 100.0, 215.0}) {
            const double sun = relief_light_azimuth({crests, 1.0}, camera);
            EXPECT_GE(sun, 0.0);
            EXPECT_LT(sun, 360.0);
            EXPECT_LE(std::abs(std::remainder(sun - crests, 180.0)), 20.0 + 1e-9)
                << "light across parallel crests";
        }
    }
}

TEST(ReliefView, ExaggeratesByARoundNumberUpTo45Degrees) {
    Snapshot low = waves(90.0, 0.025);
    low.scale = {1.0, 1.0, 1.0, true};
    EXPECT_EQ(figure_exaggeration(low), 50.0) << ".05 m of 60 m; 100 would be steeper than 45°";
    Snapshot steep = waves(90.0, 3.0);
    steep.scale = low.scale;
    EXPECT_EQ(figure_exaggeration(steep), 1.0) << "metres are never flattened";
    steep.scale = {};
    EXPECT_EQ(figure_exaggeration(steep), 0.5) << "heights without a unit are";
    EXPECT_EQ(figure_exaggeration(waves(90.0, 0.0)), 1.0);
    EXPECT_EQ(figure_exaggeration(waves(90.0, 0.3)), 5.0) << "without metres too";
}

TEST(ReliefView, TakesWhatTheSceneSays) {
    const Snapshot bed = waves(90.0, 0.3);
    View view;
    const View usual = relief_view(view, bed, {&bed, 1});
    EXPECT_NEAR(usual.sun.azimuth, 290.0, 0.1);
    EXPECT_EQ(usual.look.exaggeration.value, 5.0);
    EXPECT_EQ(usual.look.relief, FigureRelief::clear);
    view.sun.azimuth = 100.0;
    view.look.exaggeration = {"", 2.0};
    const View own = relief_view(view, bed, {&bed, 1});
    EXPECT_EQ(own.sun.azimuth, 100.0);
    EXPECT_EQ(own.sun.elevation, view.sun.elevation);
    EXPECT_EQ(own.look.exaggeration.value, 2.0);
}

TEST(ReliefView, TheBlockHoldsAllSnapshotsAndIsThin) {
    const Snapshot first = waves(90.0, 0.1);
    Snapshot later = waves(90.0, 1.0);
    for (double& height : later.bed.values()) height -= 3.0;
    const std::vector<Snapshot> shown{first, later};
    const Block block = framed_block(relief_view({}, first, shown), first);
    EXPECT_NEAR(block.z(-4.0) - block.base, 0.02, 1e-9);
    EXPECT_GE(block.top, block.z(0.1));
    EXPECT_LT(block.top, block.z(0.1) + 0.02);
    const Block previous = frame_block(first, 1.0);
    EXPECT_NEAR(frame_block(first, 1.0, {"auto", 0.0}, {"auto", 0.0}).base, previous.base, 0.0);
}

TEST(Outlined, DarkensTheEdgeOfWhatIsOpaque) {
    Image image = with_alpha(Image(20, 20));
    std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{200});
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x)
            image.alpha[static_cast<std::size_t>(20 * y + x)] = x >= 5 && x < 15 ? 255 : 0;
    }
    const Image drawn = outlined(image, 2.0);
    const auto at = [&](int x) { return static_cast<int>(drawn.row(10)[3 * x]); };
    EXPECT_FALSE(drawn.transparent());
    EXPECT_EQ(at(2), 255);
    EXPECT_EQ(at(5), 70);
    EXPECT_EQ(at(14), 70);
    EXPECT_EQ(at(9), 200);
    const Image opaque(4, 4);
    EXPECT_EQ(outlined(opaque, 2.0), opaque);
}

}  // namespace
}  // namespace fumon
