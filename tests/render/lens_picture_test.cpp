#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/ready_picture.h"
#include "render/renderer.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"
#include "vectors/target.h"

namespace fumon {
namespace {

/// A level plate of sites, seen from straight above near its eastern edge, with nothing behind it.
View above_an_edge(double above) {
    View view = small_view(240, 120);
    view.look.ground = Ground::table;
    view.look.background = Background::transparent;
    view.look.exaggeration = 1.0;
    view.camera.azimuth = 180.0;
    view.camera.elevation = 90.0;
    view.camera.at = {36.0, 15.0, above};
    view.camera.look_at = {36.0, 15.0, 0.0};
    view.camera.field_of_view = 40.0;
    view.camera.lens_samples = 256.0;
    return view;
}

Snapshot plate() {
    Snapshot bed;
    bed.bed = Grid(40, 30, 3.0);
    return bed;
}

LayeredImage light_through(const View& view, const Snapshot& bed, bool positions = false) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    return Renderer(*context, view, bed, 100, pool, {}, PixelFormat::radiance)
        .render_layers(bed, positions);
}

const std::vector<float>& channel(const LayeredImage& image, const std::string& name) {
    return std::ranges::find(image.layers, name, &ImageLayer::name)->values;
}

/// The diameter of the disc over which an edge is spread along the middle row: a disc's projection
/// has a variance of a sixteenth of its square.
double spread_of_edge(const View& view) {
    const LayeredImage image = light_through(view, plate());
    const auto& opacity = channel(image, "A");
    const std::size_t row = 60 * static_cast<std::size_t>(image.width);
    double sum = 0.0;
    double mean = 0.0;
    double squares = 0.0;
    for (int x = 1; x < image.width; ++x) {
        const auto at = row + static_cast<std::size_t>(x);
        const double step = static_cast<double>(opacity[at - 1]) - static_cast<double>(opacity[at]);
        sum += step;
        mean += step * x;
        squares += step * x * x;
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
    const double pixel = 1.0 / 12.0;
    return 4.0 * std::sqrt(std::max(squares - mean * mean - pixel, 0.0));
}

TEST(LensPicture, AnEdgeIsSpreadOverItsCircleOfConfusion) {
    for (const double focus : {4.0, 8.0, 10.0, 16.0, 1e9}) {
        constexpr double depth = 10.0;
        View view = above_an_edge(depth);
        view.camera.aperture = 2.0;
        view.camera.focus = focus;
        const double half = std::tan(0.5 * 40.0 * 3.14159265358979 / 180.0);
        const double expected = 2.0 * std::abs(1.0 / depth - 1.0 / focus) * 120.0 / (2.0 * half);
        EXPECT_NEAR(spread_of_edge(view), expected, 0.5) << focus;
    }
}

TEST(LensPicture, AutoFocusesOnWhatTheCameraLooksAtOrOnTheGroundBeforeIt) {
    View view = above_an_edge(10.0);
    view.camera.aperture = 2.0;
    EXPECT_LT(spread_of_edge(view), 0.5);
    view.camera.at = {36.0, 15.0, 10.0};
    view.camera.look_at.clear();
    EXPECT_LT(spread_of_edge(view), 0.5);
    view.camera.look_at = {36.0, 15.0, 5.0};
    EXPECT_GT(spread_of_edge(view), 10.0);
}

/// The mean size of the differences of two pictures, levels.
double apart_by(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::abs(static_cast<int>(a.rgb[i]) - static_cast<int>(b.rgb[i]));
    return sum / static_cast<double>(a.rgb.size());
}

/// Of neighbours along rows.
double contrast_along_rows(const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 3; i < image.rgb.size(); ++i)
        sum += std::abs(static_cast<int>(image.rgb[i]) - static_cast<int>(image.rgb[i - 3]));
    return sum / static_cast<double>(image.rgb.size());
}

/// A bed in metres that goes on to the horizon, seen from near.
Snapshot rippled_sand() {
    Snapshot bed = wavy_bed(120, 90);
    bed.scale = {1.0, 1.0, 0.3, true, {}};
    bed.periodic = true;
    return bed;
}

View from_near(int width = 240, int height = 135) {
    View view = small_view(width, height);
    view.camera.at = {60.0, 45.0, 1.5};
    view.camera.look_at = {64.0, 49.0, 0.0};
    view.camera.focal_length = 50.0;
    view.sun.elevation = 15.0;
    view.camera.lens_samples = 16.0;
    return view;
}

TEST(LensPicture, ANarrowLensIsAPinhole) {
    for (const bool endless : {true, false}) {
        const Snapshot bed = rippled_sand();
        View view = from_near();
        view.look.ground = endless ? Ground::endless : Ground::table;
        if (!endless) {
            view.camera.at.clear();
            view.camera.look_at.clear();
        }
        const Image pinhole = picture(view, bed);
        view.camera.f_number = 1e6;
        const Image narrow = picture(view, bed);
        EXPECT_LT(apart_by(narrow, pinhole), 1.5) << endless;
        EXPECT_GT(contrast_along_rows(narrow), 0.9 * contrast_along_rows(pinhole)) << endless;
        if (!endless) continue;
        view.camera.f_number = 1.0;
        view.camera.focus = 1.0;
        EXPECT_LT(contrast_along_rows(picture(view, bed)), 0.7 * contrast_along_rows(pinhole));
    }
}

/// Straight from above, level ground lies in the plane of focus all over.
TEST(LensPicture, WhatIsInFocusIsAsSharpAsThroughAPinhole) {
    Snapshot bed = rippled_sand();
    std::ranges::fill(bed.bed.values(), 1.0);
    View view = from_near();
    view.camera.elevation = 89.0;
    view.camera.at = {60.0, 45.0, 4.0};
    view.camera.look_at = {60.0, 45.01, 0.0};
    const Image pinhole = picture(view, bed);
    view.camera.f_number = 1.4;
    const Image focused = picture(view, bed);
    EXPECT_LT(apart_by(focused, pinhole), 2.0);
    EXPECT_GT(contrast_along_rows(focused), 0.9 * contrast_along_rows(pinhole));
    view.camera.focus = 1.0;
    EXPECT_LT(contrast_along_rows(picture(view, bed)), 0.7 * contrast_along_rows(pinhole));
}

TEST(LensPicture, IsTheSameForAnyThreadsTargetsAndTiles) {
    const Snapshot bed = rippled_sand();
    for (const bool endless : {true, false}) {
        View view = from_near(200, 120);
        view.look.ground = endless ? Ground::endless : Ground::table;
        view.camera.f_number = 1.4;
        view.camera.focus = 3.0;
        if (!endless) {
            view.camera.f_number = {"pinhole", 0.0};
            view.camera.aperture = 5.0;
            view.camera.at.clear();
            view.camera.look_at.clear();
            view.camera.focus = {"auto", 0.0};
        }
        const Image expected = picture(view, bed);
        EXPECT_EQ(picture(view, bed, 1), expected) << endless;
        setenv("LP_NUM_THREADS", "1", 1);
        EXPECT_EQ(picture(view, bed), expected) << endless;
        unsetenv("LP_NUM_THREADS");
        RenderLimits tiles;
        tiles.tile_samples = 150;
        // As of any picture, single pixels of edges may differ; a seam would be a row of them.
        const Image tiled = picture(view, bed, 2, gl::Backend::automatic, tiles);
        int off = 0;
        for (std::size_t k = 0; k < tiled.rgb.size(); ++k) {
            const int by = std::abs(static_cast<int>(tiled.rgb[k]) - expected.rgb[k]);
            ASSERT_LE(by, 8) << endless;
            off += by > 0 ? 1 : 0;
        }
        EXPECT_LE(off, 150) << endless;
        const std::string before = vectors::target();
        for (const std::string& target : vectors::targets()) {
            vectors::use_target(target);
            EXPECT_EQ(picture(view, bed), expected) << endless << ' ' << target;
        }
        vectors::use_target(before);
    }
}

/// Opacities are means, and colours those of what is there.
TEST(LensPicture, NothingBehindItLeavesOpacities) {
    View view = above_an_edge(10.0);
    view.camera.aperture = 2.0;
    view.camera.focus = 6.0;
    const LayeredImage deep = light_through(view, plate(), true);
    const Image image = picture(view, plate());
    ASSERT_TRUE(image.transparent());
    const auto& opacity = channel(deep, "A");
    int between = 0;
    const std::uint8_t* whole = image.row(60) + 3 * 10;
    for (std::size_t i = 0; i < opacity.size(); ++i) {
        ASSERT_EQ(image.alpha[i], std::lround(255.0 * static_cast<double>(opacity[i])));
        if (opacity[i] < 0.1F || opacity[i] > 0.9F) continue;
        ++between;
        // Thin, it is no darker.
        ASSERT_NEAR(image.rgb[3 * i], whole[0], 25) << i;
    }
    EXPECT_GT(between, 500);
    // Where things are stays what a pinhole sees.
    View pinhole = view;
    pinhole.camera.aperture = 0.0;
    EXPECT_EQ(channel(deep, "Z"), channel(light_through(pinhole, plate(), true), "Z"));
}

/// A film's camera, which looks at a place, sees what a still from there sees.
TEST(LensPicture, AFilmsFrameIsTheStill) {
    const Snapshot bed = rippled_sand();
    View view = from_near();
    view.camera.f_number = 1.4;
    const Image still = picture(view, bed);
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, bed, 100, pool);
    const Block block = framed_block(view, bed);
    FramePose pose{camera_at_step(view, block, 0, 100), view.sun};
    const auto lent = std::make_shared<const Snapshot>(bed);
    EXPECT_EQ(renderer.render(renderer.ready(lent, pose, nullptr, pool)), still);
}

TEST(LensPicture, SixteenBitsAreTheSamePicture) {
    View view = from_near();
    view.camera.f_number = 1.4;
    const Image image = picture(view, rippled_sand());
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    const Image deep =
        Renderer(*context, view, rippled_sand(), 100, pool, {}, PixelFormat::display_16)
            .render(rippled_sand());
    ASSERT_EQ(deep.rgb16.size(), image.rgb.size());
    int most = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        most = std::max(most, std::abs(static_cast<int>(image.rgb[i]) - deep.rgb[i]));
    EXPECT_LE(most, 2);  // 8 bits are dithered
    EXPECT_GT(most, 0);
}

}  // namespace
}  // namespace fumon
