#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// A block on its table under the sky.
View block_view(double elevation) {
    View view = small_view(240, 180);
    view.look.ground = Ground::table;
    view.look.light = LightKind::sun;
    view.camera.elevation = elevation;
    return view;
}

TEST(Table, EndsInHazeWithoutAnEdgeAgainstTheSky) {
    const View view = block_view(4.0);
    EXPECT_EQ(view.sun.haze, 0.0);
    const Image image = picture(view, wavy_bed(60, 50));
    int most = 0;
    for (int y = 1; y < image.height; ++y) {
        for (std::size_t c = 0; c < 3; ++c)  // beside the block
            most = std::max(most, std::abs(image.row(y)[c] - image.row(y - 1)[c]));
    }
    EXPECT_LE(most, 6);
    // Sky there is, over a table.
    EXPECT_GT(image.row(0)[2], image.row(0)[0]);
    EXPECT_LT(image.row(image.height - 1)[2], image.row(image.height - 1)[0]);
}

TEST(Table, ShadeOnItIsBluerThanTheLight) {
    const Image image = picture(block_view(35.0), wavy_bed(60, 50));
    const std::uint8_t* darkest = nullptr;  // of the bluish ones: neither soil nor sand
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            if (pixel[2] > pixel[0] && (darkest == nullptr || pixel[1] < darkest[1]))
                darkest = pixel;
        }
    }
    ASSERT_NE(darkest, nullptr);
    const std::uint8_t* lit = image.row(image.height - 1);
    EXPECT_GT(1.0 * darkest[2] / darkest[0], 1.2 * lit[2] / lit[0]);
    EXPECT_LT(darkest[1], 0.8 * lit[1]);
}

}  // namespace
}  // namespace fumon
