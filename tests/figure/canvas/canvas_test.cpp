#include "figure/canvas/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace fumon {
namespace {

std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::uint8_t* at = image.row(y) + std::ptrdiff_t{3} * x;
    return {at[0], at[1], at[2]};
}

TEST(Canvas, FillsWhatItIsTold) {
    Canvas canvas(20, 10, 8.0);
    canvas.fill(CanvasBox{5, 2, 10, 4}, {1.0, 0.0, 0.2, 1.0});
    const Image image = canvas.image();
    EXPECT_EQ(pixel(image, 5, 2), (std::array<int, 3>{255, 0, 51}));
    EXPECT_EQ(pixel(image, 14, 5), (std::array<int, 3>{255, 0, 51}));
    EXPECT_EQ(pixel(image, 4, 2), (std::array<int, 3>{255, 255, 255}));
    EXPECT_EQ(pixel(image, 5, 6), (std::array<int, 3>{255, 255, 255}));
}

TEST(Canvas, KeepsInkWithinTheBoxOfItsText) {
    for (const bool upright : {false, true}) {
        Canvas canvas(200, 200, 20.0);
        canvas.write("τ 0.02 Pa", {100, 100}, {0.5, 0.5}, {}, 1.0, upright);
        const Image image = canvas.image();
        ASSERT_EQ(canvas.texts().size(), 1U);
        const CanvasBox box = canvas.texts().front().box;
        EXPECT_EQ(box.height > box.width, upright);
        int inside = 0;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 200; ++x) {
                if (pixel(image, x, y)[0] > 200) continue;
                ++inside;
                EXPECT_TRUE(x >= box.x - 1 && x <= box.x + box.width + 1 && y >= box.y - 1 &&
                            y <= box.y + box.height + 1);
            }
        }
        EXPECT_GT(inside, 100);
    }
}

TEST(Canvas, GivesTheSamePixelsAgain) {
    const auto drawn = [] {
        Canvas canvas(120, 60, 12.0);
        canvas.write("velocity (m/s)", {60, 30}, {0.5, 0.5}, {});
        const std::array<CanvasPoint, 3> line{{{1, 1}, {50, 20}, {110, 55}}};
        canvas.stroke(line, 1.5, {0.0, 0.3, 0.6, 0.7});
        return canvas.image();
    };
    EXPECT_EQ(drawn(), drawn());
}

}  // namespace
}  // namespace fumon
