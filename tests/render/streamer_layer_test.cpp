#include "render/streamers/streamer_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <vector>

#include "render/ready_picture.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"
#include "support/slip_face.h"

namespace fumon {
namespace {

/// Along the brink of slip_face(), a little west of it, against a low sun.
View along_brink(double strength = 1.0) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {72.0, 10.0, 4.0};
    view.camera.look_at = {60.0, 40.0, 0.5};
    view.sun.azimuth = 320.0;
    view.sun.elevation = 9.0;
    view.streamers.strength = strength;
    return view;
}

double brightness(const Image& image) {
    double sum = 0.0;
    for (const std::uint8_t value : image.rgb) sum += value;
    return sum / static_cast<double>(image.rgb.size());
}

std::size_t differing(const Image& one, const Image& other) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i) {
        if (one.rgb[i] != other.rgb[i]) ++count;
    }
    return count;
}

int farthest(const Image& one, const Image& other) {
    int apart = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        apart = std::max(apart, std::abs(int{one.rgb[i]} - int{other.rgb[i]}));
    return apart;
}

TEST(StreamerLayer, NoFluxAndNoStrengthLeaveEveryPixel) {
    const Image without = picture(along_brink(0.0), slip_face(1.0));
    EXPECT_TRUE(picture(along_brink(1.0), slip_face(0.0)).rgb == without.rgb);
    EXPECT_GT(differing(picture(along_brink(1.0), slip_face(1.0)), without), 5000U);
}

TEST(StreamerLayer, MoreFluxGlowsMoreAgainstTheSun) {
    View view = along_brink();
    view.look.contrast = {"auto-0.2", 0.0};  // a power alone, without a toe that lifts shade
    const double none = brightness(picture(view, slip_face(0.0)));
    const double some = brightness(picture(view, slip_face(0.6)));
    const double more = brightness(picture(view, slip_face(2.0)));
    EXPECT_GT(some, none + 0.2);
    EXPECT_GT(more, some + 0.5);
}

TEST(StreamerLayer, SameBytesByThreadsAndBackends) {
    const Image one = picture(along_brink(), slip_face(2.0), 1);
    EXPECT_TRUE(picture(along_brink(), slip_face(2.0), 3).rgb == one.rgb);
    EXPECT_TRUE(picture(along_brink(), slip_face(2.0), 1, gl::Backend::egl).rgb == one.rgb);
}

TEST(StreamerLayer, TilesLeaveNoSeams) {
    for (const int factor : {1, 2}) {
        View view = along_brink();
        view.image.width = 397;
        view.image.supersampling = factor;
        RenderLimits limits;
        limits.tile_samples = 256;
        const Image tiled = picture(view, slip_face(2.0), 1, gl::Backend::automatic, limits);
        EXPECT_TRUE(tiled.rgb == picture(view, slip_face(2.0)).rgb) << factor;
    }
}

// Edges side by side, and where somebody stands, behind the camera, among all samples.
TEST(StreamerLayer, EveryWayOfColouringSamplesSeesThroughIt) {
    View view = along_brink();
    const Image side_by_side = picture(view, slip_face(2.0));
    view.persons.push_back({.at = {90.0, 2.0}});
    EXPECT_TRUE(picture(view, slip_face(2.0)).rgb == side_by_side.rgb);
    for (const int factor : {1, 4}) {
        view = along_brink();
        view.image.supersampling = factor;
        View none = view;
        none.streamers.strength = 0.0;
        const double glow =
            brightness(picture(view, slip_face(2.0))) - brightness(picture(none, slip_face(2.0)));
        const double usual =
            brightness(side_by_side) - brightness(picture(along_brink(0.0), slip_face(2.0)));
        EXPECT_NEAR(glow / usual, 1.0, 0.05) << factor;
    }
}

double levels_apart(const Image& one, const Image& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        sum += std::abs(int{one.rgb[i]} - int{other.rgb[i]});
    return sum / static_cast<double>(one.rgb.size());
}

TEST(StreamerLayer, IsSeenThroughALensAsThroughAPinhole) {
    const auto glow = [](const CameraSettings& lens, const RenderLimits& limits) {
        View view = along_brink();
        view.image.width = 128;
        view.image.height = 80;
        view.camera.aperture = lens.aperture;
        view.camera.focus = lens.focus;
        view.camera.lens_samples = {"", 4.0};
        return picture(view, slip_face(2.0), 1, gl::Backend::automatic, limits);
    };
    CameraSettings lens;
    const Image pinhole = glow(lens, {});
    lens.aperture = 1e-6;
    View clear = along_brink(0.0);
    clear.image.width = 128;
    clear.image.height = 80;
    const Image bare = picture(clear, slip_face(2.0));
    const double none = levels_apart(bare, pinhole);
    const Image narrow = glow(lens, {});
    clear.camera.aperture = lens.aperture;
    clear.camera.lens_samples = {"", 4.0};
    const double otherwise = levels_apart(picture(clear, slip_face(2.0)), bare);
    EXPECT_LT(levels_apart(narrow, pinhole), otherwise + 0.1 * none);
    RenderLimits tiles;
    tiles.tile_samples = 48;
    EXPECT_LT(levels_apart(glow(lens, tiles), narrow), 0.05);
    // The brink is some 20 to 40 metres away.
    lens.aperture = 1.0;
    lens.focus = {"", 30.0};
    const double sharp = levels_apart(glow(lens, {}), pinhole);
    lens.focus = {"", 4.0};
    EXPECT_GT(levels_apart(glow(lens, {}), pinhole), 1.5 * sharp);
}

/// A person in the plumes is a shadow behind what glows.
TEST(StreamerLayer, VeilsWhoStandsInIt) {
    const auto drawn = [](double strength, bool person) {
        View view = along_brink(strength);
        if (person) view.persons.push_back({.at = {60.3, 36.0}});
        return picture(view, slip_face(2.0));
    };
    const Image without = drawn(0.0, false);
    const Image clear = drawn(0.0, true);
    const Image veiled = drawn(1.0, true);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < clear.rgb.size(); ++i) {
        if (std::abs(int{clear.rgb[i]} - int{without.rgb[i]}) < 5) continue;
        sum += int{veiled.rgb[i]} - int{clear.rgb[i]};
        ++count;
    }
    ASSERT_GT(count, 100);
    EXPECT_GT(sum / count, 2.0) << sum / count;
}

TEST(StreamerLayer, SixteenBitsRoundToEight) {
    const Snapshot bed = slip_face(2.0);
    const Image eight = picture(along_brink(), bed);
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, along_brink(), bed, 100, pool, {}, PixelFormat::display_16);
    EXPECT_LE(farthest(renderer.render(bed), eight), 2);
}

TEST(StreamerLayer, AFilmsFramesTakeThePlaceOfSteps) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    const auto bed = std::make_shared<Snapshot>(slip_face(2.0));
    bed->step = 7;
    const View view = along_brink();
    Renderer renderer(*context, view, *bed, 100, pool);
    const Image run = renderer.render(*bed);
    FramePose pose{camera_at_step(view, framed_block(view, *bed), 7, 100), view.sun};
    const auto drawn = [&](std::optional<std::int64_t> frame) {
        pose.frame = frame;
        return renderer.render(renderer.ready(bed, pose, nullptr, pool));
    };
    EXPECT_TRUE(drawn({}).rgb == run.rgb);
    EXPECT_TRUE(drawn(7).rgb == run.rgb);
    EXPECT_GT(differing(drawn(8), run), 1000U);
    EXPECT_TRUE(drawn(7).rgb == run.rgb) << "nothing of the other frame is kept";
}

// Of several pictures from one camera the sky is drawn anew for each.
TEST(StreamerLayer, LaterPicturesAreAsIfAlone) {
    Snapshot first = slip_face(2.0);
    Snapshot second = first;
    second.step = 3;
    View view = along_brink();
    view.sun.diameter = 1.0;
    const std::vector<Image> both = pictures(view, {first, second, first});
    EXPECT_TRUE(both[2].rgb == both[0].rgb);
    EXPECT_TRUE(both[1].rgb == picture(view, second).rgb);
    EXPECT_GT(differing(both[0], both[1]), 1000U);
}

}  // namespace
}  // namespace fumon
