#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// A wall of bare rock, 16 m high, that faces west and falls by 2 to 1, and what stands before it.
Snapshot wall() {
    Snapshot bed;
    bed.bed = Grid(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            bed.bed(x, y) = std::clamp(2.0 * (x - 20), 0.0, 16.0) * (x < 50 ? 1.0 : 0.0);
    }
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.fields = {{"sand", "", "m", Grid(64, 64, 0.0)}};
    return bed;
}

View from(std::vector<double> at, std::vector<double> look_at) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.mark = Marking::ground;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = std::move(at);
    view.camera.look_at = std::move(look_at);
    return view;
}

/// Of means along one way over a part of the picture, what they differ by from one to the next.
double steps_between(const Image& image, bool of_rows) {
    constexpr int left = 110;
    constexpr int top = 110;
    constexpr int side = 60;
    double sum = 0.0;
    double before = 0.0;
    for (int line = 0; line < side; ++line) {
        double mean = 0.0;
        for (int i = 0; i < side; ++i) {
            const int x = left + (of_rows ? i : line);
            const int y = top + (of_rows ? line : i);
            mean += image.row(y)[3 * x + 1] / static_cast<double>(side);
        }
        if (line > 0) sum += std::abs(mean - before);
        before = mean;
    }
    return sum / (side - 1);
}

// Texture laid out over the plan would be drawn out down the wall, and its columns would differ the
// most.
TEST(Rock, LiesInBedsOnAWall) {
    View view = from({2.0, 32.0, 9.0}, {24.0, 32.0, 8.0});
    view.sun.azimuth = 250.0;
    view.sun.elevation = 35.0;
    const Image image = picture(view, wall());
    EXPECT_GT(steps_between(image, true), 2.0 * steps_between(image, false));
    EXPECT_GT(steps_between(image, true), 1.0);
}

// The ratio by which rough ground throws light back grows without bound as sun and eye come along
// it.
TEST(Rock, DoesNotSparkleInASunAlongIt) {
    View view = from({14.0, 2.0, 9.0}, {24.0, 40.0, 8.0});
    view.sun.azimuth = 188.0;
    view.sun.elevation = 20.0;
    const Image image = picture(view, wall());
    double sum = 0.0;
    int brightest = 0;
    for (int y = 110; y < 180; ++y) {
        for (int x = 180; x < 320; ++x) {
            const int green = image.row(y)[3 * static_cast<std::size_t>(x) + 1];
            sum += green;
            brightest = std::max(brightest, green);
        }
    }
    EXPECT_LT(brightest, 1.55 * sum / (70.0 * 140.0));
}

}  // namespace
}  // namespace fumon
