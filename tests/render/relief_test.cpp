// look.relief = "clear": figures shaded as block diagrams are drawn.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "render/view/framing.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// Waves of 12 cells whose crests run north.
Snapshot waves() {
    Snapshot snapshot;
    snapshot.bed = Grid(60, 60);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x)
            snapshot.bed(x, y) = 0.9 * std::sin(2.0 * std::numbers::pi * x / 12.0);
    }
    return snapshot;
}

View figure_of(FigureRelief relief) {
    View view = small_view(360, 240);
    view.look.mode = ViewMode::figure;
    view.look.relief = relief;
    view.look.footing = {"", 2.0};
    view.sun.azimuth = 290.0;
    view.sun.elevation = 38.0;
    return view;
}

/// Mean and standard deviation of the greens in the middle of a picture.
std::array<double, 2> greens_of(const Image& image) {
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (int y = image.height * 2 / 5; y < image.height * 3 / 5; ++y) {
        for (int x = image.width * 2 / 5; x < image.width * 3 / 5; ++x) {
            const double green = image.row(y)[3 * x + 1];
            sum += green;
            squares += green * green;
            count += 1.0;
        }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean)};
}

TEST(ClearRelief, CrestsStandOutTwiceAsMuchAndAreLightOnOneSide) {
    const auto soft = greens_of(picture(figure_of(FigureRelief::soft), waves()));
    const auto clear = greens_of(picture(figure_of(FigureRelief::clear), waves()));
    EXPECT_GT(clear[1], 1.6 * soft[1]);
    EXPECT_GT(clear[1], 35.0);
    EXPECT_GT(clear[0], 120.0) << "and yet light";
}

TEST(ClearRelief, SidesArePlainAndLightWithADarkLineAlongTheFoot) {
    const View view = figure_of(FigureRelief::clear);
    const Image drawn = picture(view, waves());
    const Block block = framed_block(view, waves());
    const Camera camera = camera_at_step(view, block, 0, 100);
    const auto pixel = [&](double height) {
        const glm::dvec2 at = project(camera, {0.2, -0.5, block.base + height});
        return colour_at(drawn, 0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y);
    };
    const auto face = pixel(0.02);
    EXPECT_GT(*std::ranges::min_element(face), 200);
    EXPECT_LT(std::abs(face[0] - face[2]), 12) << "no colour";
    int darkest = 255;
    for (double height = 0.0; height < 0.01; height += 0.0005)
        darkest = std::min(darkest, pixel(height)[1]);
    EXPECT_LT(darkest, 190);
}

}  // namespace
}  // namespace fumon
