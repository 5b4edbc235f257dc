#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/panels/map_panel.h"
#include "render/colour/palette.h"

namespace fumon::test {
namespace {

using Colour = std::array<int, 3>;

Colour colour_at(const Image& image, double x, double y) {
    const std::uint8_t* pixel = image.row(static_cast<int>(y)) + 3 * static_cast<int>(x);
    return {pixel[0], pixel[1], pixel[2]};
}

int largest_difference(const Colour& a, const Colour& b) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

TEST(MapLines, DrawsDirectionsThroughItsMiddle) {
    MapPicture picture;
    picture.values = Grid(12, 12, 1.0);
    picture.blank = Mask(12, 12);
    picture.colours = {read_palette("viridis"), 0.0, 2.0, ""};
    const auto drawn = [&](const std::vector<MapLine>& lines) {
        MapPanelSettings settings;
        settings.axes = false;
        settings.colour_bar = BarPosition::none;
        settings.lines = lines;
        Canvas canvas(240, 240, 24.0);
        MapPanel(picture, settings).draw(canvas, {20.0, 20.0, 200.0, 200.0});
        return canvas.image();
    };
    const Image plain = drawn({});
    const Image measured = drawn({{{0.8, 0.6}, false}});  // to the east, and less to the north
    EXPECT_EQ(colour_at(measured, 120.0 + 60.0, 120.0 - 45.0), (Colour{0, 0, 0}));
    EXPECT_EQ(colour_at(measured, 120.0 - 60.0, 120.0 + 45.0), (Colour{0, 0, 0}));
    EXPECT_EQ(colour_at(measured, 120.0 + 60.0, 120.0 + 45.0),
              colour_at(plain, 120.0 + 60.0, 120.0 + 45.0));
    const Image predicted = drawn({{{0.8, 0.6}, true}});
    int red = 0;
    int gaps = 0;
    for (int n = -70; n <= 70; ++n) {
        const Colour seen = colour_at(predicted, 120.0 + 0.8 * n, 120.0 - 0.6 * n);
        red += largest_difference(seen, {209, 26, 20}) <= 2 ? 1 : 0;
        gaps += seen[1] > 128 ? 1 : 0;
    }
    EXPECT_GT(red, 40);
    EXPECT_GT(gaps, 20);
}

}  // namespace
}  // namespace fumon::test
