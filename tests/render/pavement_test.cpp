#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "base/snapshot.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// Level rock under so much sand.
Snapshot level_rock(double sand) {
    Snapshot bed;
    bed.bed = Grid(64, 64, 0.0);
    bed.bed(0, 0) = 1.0;
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.fields = {{"sand", "", "m", Grid(64, 64, sand)}};
    return bed;
}

View from_height(double height, RockSurface rock) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.mark = Marking::ground;
    view.look.rock = rock;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {32.0, 10.0, height};
    view.camera.look_at = {32.0, 10.0 + 2.0 * height, 0.0};
    view.sun.elevation = 40.0;
    return view;
}

/// Means of the colours over the lower half of a picture.
std::array<double, 3> mean_below(const Image& image) {
    std::array<double, 3> sums{};
    const int top = image.height / 2;
    for (int y = top; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c)
                sums[c] += image.row(y)[3 * static_cast<std::size_t>(x) + c];
        }
    }
    for (double& sum : sums) sum /= static_cast<double>(image.width) * (image.height - top);
    return sums;
}

double saturation(const std::array<double, 3>& colour) {
    const auto [least, most] = std::ranges::minmax(colour);
    return (most - least) / most;
}

TEST(Pavement, IsDarkerAndGreyerThanSandAndThanWeatheredRock) {
    const auto pavement =
        mean_below(picture(from_height(8.0, RockSurface::pavement), level_rock(0.0)));
    const auto weathered =
        mean_below(picture(from_height(8.0, RockSurface::weathered), level_rock(0.0)));
    const auto sand = mean_below(picture(from_height(8.0, RockSurface::pavement), level_rock(1.0)));
    EXPECT_LT(pavement[0], 0.95 * weathered[0]);
    EXPECT_LT(saturation(pavement), saturation(weathered));
    EXPECT_LT(pavement[1], 0.8 * sand[1]);
}

TEST(Pavement, LeavesSandAsItIs) {
    EXPECT_EQ(picture(from_height(8.0, RockSurface::pavement), level_rock(1.0)),
              picture(from_height(8.0, RockSurface::weathered), level_rock(1.0)));
}

// Stones that are finer than pixels leave their mean: the same ground, not a darker one.
TEST(Pavement, IsAsBrightWhereItsStonesAreNotSeen) {
    View view = from_height(4.0, RockSurface::pavement);
    const auto seen = mean_below(picture(view, level_rock(0.0)));
    view.image.width /= 8;
    view.image.height /= 8;
    const auto unseen = mean_below(picture(view, level_rock(0.0)));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], unseen[c], 0.03 * unseen[c]) << c;
}

TEST(Pavement, ShowsOnABlockToo) {
    View view = from_height(8.0, RockSurface::weathered);
    view.look.ground = Ground::table;
    view.camera.at.clear();
    view.camera.look_at.clear();
    const Image weathered = picture(view, level_rock(0.0));
    view.look.rock = RockSurface::pavement;
    EXPECT_NE(picture(view, level_rock(0.0)), weathered);
}

}  // namespace
}  // namespace fumon
