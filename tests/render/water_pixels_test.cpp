#include "render/water/water_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "render/ready_picture.h"
#include "render/view/framing.h"
#include "render/view/visible_part.h"
#include "support/drawn_picture.h"
#include "support/rained_gully.h"
#include "support/water_views.h"

namespace fumon {
namespace {

/// Looks north over a square bed of 100 m, from a height and from so far before its southern edge.
View view_from(double before, double height, int side = 240) {
    View view = map_view(side);
    view.camera.projection = Projection::perspective;
    view.camera.at = {50, -before, height};
    view.camera.look_at = {50, 14, 0};
    return view;
}

/// The mean square of the differences of neighbouring pixels in the lower third.
double gradient_energy(const Image& image) {
    double sum = 0.0;
    int count = 0;
    for (int y = image.height / 2; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            const double difference = int{pixel[1]} - int{pixel[-2]};
            sum += difference * difference;
            ++count;
        }
    }
    return sum / count;
}

TEST(WaterPixels, NearGroundIsSharperThanATextureOverTheBed) {
    const Snapshot rained = under_water(flat_bed(100, 100), 0.0005, 0.0);
    View view = view_from(-6.0, 2.0);
    const double by_pixels = gradient_energy(picture(view, rained));
    view.camera.f_number = {"", 1e4};  // sharp everywhere, but through a lens
    view.camera.lens_samples = {"", 4};
    EXPECT_FALSE(shades_water_by_pixel(view, rained));
    EXPECT_GT(by_pixels, 2.0 * gradient_energy(picture(view, rained)));
}

// Where a texture over the bed would double its size as the camera nears, two frames are alike.
TEST(WaterPixels, NothingPopsWhereATextureWouldBeMadeFiner) {
    const Snapshot rained = under_water(flat_bed(100, 100), 0.0005, 0.0);
    const View view = view_from(60.0, 30.0, 480);
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, rained, 100, pool);
    const auto shared = std::make_shared<Snapshot>(rained);
    const auto nearer = [](double height) {
        View above = view_from(-40.0, height, 480);
        above.camera.look_at = {50, 50, 0};
        return above;
    };
    const auto camera = [&](double before) {
        return camera_at_step(nearer(before), framed_block(nearer(before), rained), 0, 100);
    };
    const auto drawn = [&](double before) {
        return renderer.render(renderer.ready(shared, {camera(before), view.sun}, nullptr, pool));
    };
    // Texels along the bed: 1024 at first, doubled when there are as many pixels.
    const double texels = 2048.0;
    double far = 200.0;
    double near = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (far + near);
        const View seen = nearer(middle);
        const bool finer =
            visible_part(camera(middle), seen, framed_block(seen, rained)).sharpness >= texels;
        (finer ? near : far) = middle;
    }
    const Image before = drawn(1.0005 * far);
    const Image after = drawn(0.9995 * far);
    double sum = 0.0;
    for (std::size_t i = 0; i < before.rgb.size(); ++i)
        sum += std::abs(int{before.rgb[i]} - int{after.rgb[i]});
    EXPECT_LT(sum / static_cast<double>(before.rgb.size()), 0.5);
}

/// A smooth ridge along a line aslant to the grid, its shadow on level ground east of it.
Snapshot slanting_ridge() {
    Snapshot snapshot = flat_bed(100, 100);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            const double off = (x - 30.0 - 0.31 * y) / 4.0;
            snapshot.bed(x, y) = 6.0 * std::exp(-off * off);
        }
    }
    return under_water(std::move(snapshot), 0.0, 0.0);
}

TEST(WaterPixels, AShadowsEdgeHasNoStepsOfCells) {
    View view = view_from(10.0, 60.0);
    view.camera.at = {64, 44, 9};
    view.camera.look_at = {64, 50, 1};
    view.sun.azimuth = 270.0 + 17.2;  // across the ridge
    view.sun.elevation = 20.0;
    view.sun.diameter = 0.3;
    const Image image = picture(view, slanting_ridge());
    // Along rows, the first place from the east that is in the dark; its second difference shows
    // steps, whatever the perspective does to a straight line.
    std::vector<double> edge;
    for (int y = 40; y < 200; ++y) {
        const auto brightness = [&](int x) {
            return static_cast<double>(image.row(y)[3 * static_cast<std::size_t>(x) + 1]);
        };
        const double lit = brightness(230);
        int x = 230;
        while (x > 1 && brightness(x) > 0.86 * lit) --x;
        const double over = brightness(x + 1) - brightness(x);
        edge.push_back(x + (0.86 * lit - brightness(x)) / std::max(over, 1.0));
    }
    // A stone there may be as dark or as bright as the other side.
    std::vector<double> smooth;
    for (std::size_t i = 2; i + 2 < edge.size(); ++i) {
        std::array<double, 5> five{};
        std::copy_n(edge.begin() + static_cast<std::ptrdiff_t>(i) - 2, 5, five.begin());
        std::sort(five.begin(), five.end());
        smooth.push_back(five[2]);
    }
    double worst = 0.0;
    for (std::size_t i = 6; i + 6 < smooth.size(); ++i)
        worst = std::max(worst, std::abs(smooth[i] - 0.5 * (smooth[i - 6] + smooth[i + 6])));
    EXPECT_LT(worst, 3.5);  // pixels; a cell of the drawn bed is ten
}

/// From over the mouth of a gully in rain, with a stream that shoots.
View view_of_gully(int width, int height) {
    View view = map_view();
    view.image.width = width;
    view.image.height = height;
    view.camera.projection = Projection::perspective;
    view.camera.at = {72, -6, 11};
    view.camera.look_at = {66, 50, 1};
    view.look.turbidity = 0.85;
    view.sun.azimuth = 80;
    return view;
}

/// Values of pixels that differ by more than `levels`.
int far_off(const Image& one, const Image& other, int levels) {
    int count = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        if (std::abs(int{one.rgb[i]} - int{other.rgb[i]}) > levels) ++count;
    return count;
}

// Dry ground, films and what is deeper have a program each, which leaves out what cannot be there.
TEST(WaterPixels, EachKindHasTheColoursOfTheProgramThatShadesAny) {
    const Snapshot rained = test::rained_gully(0.0, 4.0);
    const View view = view_of_gully(640, 360);
    RenderLimits alike;
    alike.pixels_alike = true;
    const Image any = picture(view, rained, 2, gl::Backend::automatic, alike);
    EXPECT_EQ(far_off(picture(view, rained), any, 1), 0);
}

// What is shaded of a tile is what the block covers of it, wherever the tile lies. Places of
// samples are interpolated within a tile, so that some values are a level off.
TEST(WaterPixels, TilesShowTheWholeBlock) {
    const Snapshot rained = test::rained_gully(0.0);
    RenderLimits tiles;
    tiles.tile_samples = 150;
    View whole = view_of_gully(320, 180);
    whole.camera.at.clear();
    whole.camera.look_at.clear();
    for (const View& view : {view_of_gully(320, 180), whole})
        EXPECT_EQ(far_off(picture(view, rained),
                          picture(view, rained, 2, gl::Backend::automatic, tiles), 4),
                  0);
}

/// A bank 8 m high that ends across the view, and a deep pond far below it.
Snapshot bank_before_a_pond() {
    Snapshot snapshot = under_water(flat_bed(100, 100), 0.0, 0.0);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            snapshot.bed(x, y) = y > 20 ? 0.0 : 8.0;
            snapshot.fields[0].values(x, y) = y > 20 ? 3.0 : 0.0;
        }
    }
    return snapshot;
}

// Of the samples of a row of pixels at the brink none, half or all see the bank, as the camera is
// tilted. Where it is half of them, the row's light is the mean of what its neighbours send.
TEST(WaterPixels, PixelsSplitBetweenGroundAndWaterMixTheirLight) {
    const Snapshot bed = bank_before_a_pond();
    double best = 1e9;  // of all tilts, how far a row is from that mean
    for (int tilt = 0; tilt < 12; ++tilt) {
        View view = view_from(-2.0, 4.0);
        view.camera.look_at = {50, 60, 3.0 + 0.02 * tilt};
        view.look.water_clarity = {"", 0.5};
        view.sun.haze = 0.35;  // the bound is for its contrast
        const Image image = picture(view, bed);
        const auto red = [&](int y) {  // the mean over some columns
            double sum = 0.0;
            for (std::size_t x = 80; x < 160; ++x) sum += image.row(y)[3 * x];
            return sum / 80.0;
        };
        // The brink is where the picture's red rises most.
        int brink = 80;
        for (int y = 80; y < image.height - 2; ++y)
            if (red(y + 1) - red(y - 1) > red(brink + 1) - red(brink - 1)) brink = y;
        const double far = red(brink - 1);
        const double near = red(brink + 1);
        ASSERT_GT(near - far, 40.0);
        best = std::min(best, std::abs(red(brink) - std::sqrt(0.5 * (near * near + far * far))));
    }
    EXPECT_LT(best, 4.0);
}

// What stands on a block, even beside the picture, has its samples drawn by OpenGL.
TEST(WaterPixels, AreThoseOfSamplesDrawnByOpenGL) {
    const Snapshot rained = test::rained_gully(0.0, 4.0);
    View whole = view_of_gully(640, 360);
    whole.camera.at.clear();
    whole.camera.look_at.clear();
    for (View view : {view_of_gully(640, 360), whole}) {
        const Image by_positions = picture(view, rained);
        view.tracks.resize(1);
        view.tracks[0].along = {126.0, 0.5, 127.0, 0.5};
        const Image by_samples = picture(view, rained);
        double sum = 0.0;
        for (std::size_t i = 0; i < by_positions.rgb.size(); ++i)
            sum += std::abs(int{by_positions.rgb[i]} - int{by_samples.rgb[i]});
        const auto values = static_cast<double>(by_positions.rgb.size());
        EXPECT_LT(sum / values, 0.5);
        EXPECT_LT(far_off(by_positions, by_samples, 32), 0.0005 * values);
    }
}

// Each is a cell, and a cell is about as wide as a pixel.
TEST(WaterPixels, PoolsAsSmallAsAPixelAreNoSpecks) {
    Snapshot pools = under_water(flat_bed(100, 100), 0.0, 0.0);
    for (int y = 10; y < 90; y += 8)
        for (int x = 10; x < 90; x += 8) pools.fields[0].values(x, y) = 0.3;
    View far = view_from(-50.0, 240.0, 160);
    far.camera.look_at = {50, 50.1, 0};
    far.look.water_clarity = {"", 0.1};
    const Image image = picture(far, pools);
    std::vector<int> middle;
    for (int y = 60; y < 100; ++y) {
        for (int x = 60; x < 100; ++x)
            middle.push_back(image.row(y)[3 * static_cast<std::size_t>(x) + 1]);
    }
    std::sort(middle.begin(), middle.end());
    EXPECT_GT(middle.front(), 0.65 * middle[middle.size() / 2]);
    EXPECT_LT(middle.front(), 0.97 * middle[middle.size() / 2]);  // yet they are seen
}

TEST(WaterPixels, PixelsOfATileBeginBeforeItsFirstSample) {
    EXPECT_EQ(pixel_offset({128, 64}, 2), glm::ivec2(0, 0));
    EXPECT_EQ(pixel_offset({64, 65}, 3), glm::ivec2(-2, -1));
}

}  // namespace
}  // namespace fumon
