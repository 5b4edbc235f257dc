#include "film/card_backdrop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "base/image.h"

namespace {

using fumon::card_backdrop;
using fumon::Image;

TEST(CardBackdrop, AnEvenPictureBecomesAThirdAsBright) {
    Image picture(64, 48);
    std::ranges::fill(picture.rgb, std::uint8_t{150});
    const Image made = card_backdrop(picture);
    EXPECT_EQ(made.width, 64);
    EXPECT_EQ(made.height, 48);
    EXPECT_TRUE(std::ranges::all_of(made.rgb, [](std::uint8_t level) { return level == 50; }));
}

TEST(CardBackdrop, ASpotSpreadsToBothSidesAlikeAndKeepsItsLight) {
    constexpr int side = 200;
    constexpr int half = 16;
    constexpr int middle = 100;
    Image picture(side, side);
    for (int y = middle - half; y <= middle + half; ++y)
        for (int x = middle - half; x <= middle + half; ++x) picture.row(y)[3 * x] = 255;
    const Image made = card_backdrop(picture);
    double light = 0.0;
    double spread = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double level = made.row(y)[3 * x];
            light += level;
            spread += level * (x - middle) * (x - middle);
            EXPECT_NEAR(level, made.row(2 * middle - y > 199 ? 199 : 2 * middle - y)[3 * x], 1.0);
            EXPECT_EQ(made.row(y)[3 * x + 1], 0);
        }
    }
    const double square = (2 * half + 1.0) * (2 * half + 1.0);
    EXPECT_NEAR(light / (85.0 * square), 1.0, 0.02);
    // Three boxes of radius 5 add three times 5·6/3 to the square's own 16·17/3.
    EXPECT_NEAR(spread / light, 16.0 * 17.0 / 3.0 + 3.0 * 5.0 * 6.0 / 3.0, 3.0);
}

TEST(CardBackdrop, OfAPictureWithoutColourIsOpaque) {
    Image picture(40, 40);
    picture.alpha.assign(40 * 40, 0);
    const Image made = card_backdrop(picture);
    EXPECT_FALSE(made.transparent());
    EXPECT_LE(*std::ranges::max_element(made.rgb), 6);
}

}  // namespace
