#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/snapshot.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// A wall of bare rock, 16 m high, that faces west and falls by 2 to 1, and what stands before it.
Image wall_from_the_west() {
    Snapshot bed;
    bed.bed = Grid(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            bed.bed(x, y) = std::clamp(2.0 * (x - 20), 0.0, 16.0) * (x < 50 ? 1.0 : 0.0);
    }
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.fields = {{"sand", "", "m", Grid(64, 64, 0.0)}};
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.mark = Marking::ground;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {2.0, 32.0, 9.0};
    view.camera.look_at = {24.0, 32.0, 8.0};
    view.sun.azimuth = 250.0;
    view.sun.elevation = 35.0;
    return picture(view, bed);
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
    const Image wall = wall_from_the_west();
    EXPECT_GT(steps_between(wall, true), 2.0 * steps_between(wall, false));
    EXPECT_GT(steps_between(wall, true), 1.0);
}

}  // namespace
}  // namespace fumon
