#include "render/water_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "render/ready_picture.h"
#include "render/view/framing.h"
#include "render/view/seen_part.h"
#include "support/drawn_picture.h"
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
    EXPECT_FALSE(shades_pixels(view, rained));
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
            seen_part(camera(middle), seen, framed_block(seen, rained)).sharpness >= texels;
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

TEST(WaterPixels, PixelsOfATileBeginBeforeItsFirstSample) {
    EXPECT_EQ(pixel_offset({128, 64}, 2), glm::ivec2(0, 0));
    EXPECT_EQ(pixel_offset({64, 65}, 3), glm::ivec2(-2, -1));
}

}  // namespace
}  // namespace fumon
