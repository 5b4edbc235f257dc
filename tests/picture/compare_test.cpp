#include "picture/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/renderer.h"
#include "support/dune_field.h"
#include "support/pictures.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::dune_field;
using test::flat_picture;
using test::message_of;
using test::some_picture;

TEST(Compare, TheSamePictureIsIdentical) {
    const Image image = some_picture(101, 67);
    const Comparison comparison = compare(image, image);
    EXPECT_EQ(comparison.largest, 0);
    EXPECT_EQ(comparison.changed, 0);
    EXPECT_EQ(comparison.mean, 0.0);
    EXPECT_EQ(comparison.tiles.smallest, 1.0);
    EXPECT_EQ(comparison.thumbnail.largest, 0.0);
    EXPECT_EQ(likeness(comparison), Likeness::identical);
}

/// Every place of a picture whose sides are no multiples of the tile: corners, edges, middle.
TEST(Compare, FindsAChangedPixelWhereverItIs) {
    const Image image = some_picture(101, 67);
    for (const auto& [x, y] :
         {std::pair{0, 0}, {100, 0}, {0, 66}, {100, 66}, {95, 33}, {96, 64}, {50, 30}}) {
        Image changed = image;
        std::uint8_t& level = changed.row(y)[3 * x + 1];
        level = static_cast<std::uint8_t>(level < 128 ? level + 100 : level - 100);
        const Comparison comparison = compare(image, changed);
        EXPECT_EQ(comparison.changed, 1);
        EXPECT_EQ(comparison.largest, 100);
        EXPECT_DOUBLE_EQ(comparison.changed_share, 1.0 / (101 * 67));
        EXPECT_DOUBLE_EQ(comparison.mean, 100.0 / (3 * 101 * 67));
        EXPECT_LT(comparison.tiles.smallest, 0.99) << x << ", " << y;
        EXPECT_TRUE(comparison.tiles.x <= x && x < comparison.tiles.x + 8) << comparison.tiles.x;
        EXPECT_TRUE(comparison.tiles.y <= y && y < comparison.tiles.y + 8) << comparison.tiles.y;
        EXPECT_EQ(comparison.thumbnail.x, x * 32 / 101);
        EXPECT_EQ(comparison.thumbnail.y, y * 18 / 67);
        EXPECT_NE(likeness(comparison), Likeness::identical);
    }
}

/// SSIM as its definition has it, in floating point, over one picture that is one tile.
double plain_ssim(const Image& a, const Image& b) {
    const auto luminance = [](const Image& image, int i) {
        const std::uint8_t* pixel = &image.rgb[static_cast<std::size_t>(3 * i)];
        return (77.0 * pixel[0] + 150.0 * pixel[1] + 29.0 * pixel[2]) / 256.0;
    };
    const int n = a.width * a.height;
    double mean_a = 0;
    double mean_b = 0;
    for (int i = 0; i < n; ++i) {
        mean_a += luminance(a, i) / n;
        mean_b += luminance(b, i) / n;
    }
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (int i = 0; i < n; ++i) {
        const double da = luminance(a, i) - mean_a;
        const double db = luminance(b, i) - mean_b;
        aa += da * da / (n - 1);
        bb += db * db / (n - 1);
        ab += da * db / (n - 1);
    }
    const double c1 = 0.01 * 255 * 0.01 * 255;
    const double c2 = 0.03 * 255 * 0.03 * 255;
    return (2 * mean_a * mean_b + c1) * (2 * ab + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (aa + bb + c2));
}

TEST(Compare, TilesHaveTheSimilarityOfItsDefinition) {
    for (const auto& [width, height] : {std::pair{8, 8}, {8, 5}, {3, 8}, {2, 1}}) {
        const Image image = some_picture(width, height);
        Image other = image;
        for (std::size_t i = 0; i < other.rgb.size(); i += 2)
            other.rgb[i] = static_cast<std::uint8_t>(other.rgb[i] / 2 + 3 * i % 50);
        EXPECT_NEAR(tile_similarity(image, other).smallest, plain_ssim(image, other), 1e-12)
            << width << " x " << height;
    }
}

TEST(Compare, FlatTilesAndTinyPicturesGiveNumbers) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {8, 8}, {9, 9}, {64, 36}}) {
        for (const int level : {0, 1, 128, 255}) {
            const Comparison comparison =
                compare(flat_picture(width, height, 0),
                        flat_picture(width, height, static_cast<std::uint8_t>(level)));
            EXPECT_TRUE(std::isfinite(comparison.tiles.smallest));
            EXPECT_EQ(comparison.largest, level);
            EXPECT_EQ(comparison.thumbnail.largest, level);
            EXPECT_EQ(comparison.tiles.smallest<1.0, level> 0);
        }
    }
}

TEST(Compare, ATileTurnedUpsideDownIsNegative) {
    Image stripes(16, 16);
    Image reversed(16, 16);
    for (std::size_t i = 0; i < stripes.rgb.size(); ++i) {
        stripes.rgb[i] = (i / 3) % 2 == 0 ? 50 : 200;
        reversed.rgb[i] = (i / 3) % 2 == 0 ? 200 : 50;
    }
    EXPECT_LT(compare(stripes, reversed).tiles.smallest, -0.9);
}

TEST(Compare, OtherSizesAreRefused) {
    EXPECT_EQ(message_of<InputError>([] { compare(Image(4, 3), Image(4, 4)); }),
              "pictures of 4 × 3 and 4 × 4 pixels cannot be compared");
    EXPECT_EQ(message_of<InputError>([] { compare(Image(), Image()); }),
              "pictures without pixels cannot be compared");
}

Comparison of(double thumbnail, double ssim) {
    Comparison comparison;
    comparison.changed = 1;
    comparison.thumbnail.largest = thumbnail;
    comparison.tiles.smallest = ssim;
    return comparison;
}

TEST(Likeness, NeedsBothLimits) {
    const auto [thumbnail, ssim] = same_to_the_eye_limits;
    EXPECT_EQ(likeness(of(thumbnail, ssim)), Likeness::same_to_the_eye);
    EXPECT_EQ(likeness(of(std::nextafter(thumbnail, 255.0), ssim)), Likeness::close);
    EXPECT_EQ(likeness(of(thumbnail, std::nextafter(ssim, 0.0))), Likeness::close);
    EXPECT_EQ(likeness(of(close_limits.thumbnail, close_limits.tile_ssim)), Likeness::close);
    EXPECT_EQ(likeness(of(std::nextafter(close_limits.thumbnail, 255.0), 1.0)),
              Likeness::different);
    EXPECT_EQ(likeness(of(0.0, std::nextafter(close_limits.tile_ssim, 0.0))), Likeness::different);
    EXPECT_EQ(likeness(of(std::nan(""), 1.0)), Likeness::different);
    EXPECT_EQ(likeness(of(0.0, std::nan(""))), Likeness::different);
}

TEST(Likeness, OneStrayPixelInACalmPlaceIsSeen) {
    const Image calm = flat_picture(1920, 1080, 200);
    Image stray = calm;
    std::fill_n(stray.row(500) + 3 * 900, 3, std::uint8_t{80});
    EXPECT_LT(compare(calm, stray).thumbnail.largest, 0.1) << "a thumbnail does not see it";
    EXPECT_LT(likeness(compare(calm, stray)), Likeness::same_to_the_eye);
    std::fill_n(stray.row(500) + 3 * 900, 3, std::uint8_t{197});
    EXPECT_EQ(likeness(compare(calm, stray)), Likeness::same_to_the_eye) << "three levels";
}

/// What the levels let through of pictures of dunes.
class LikenessOfDunes : public ::testing::Test {
  protected:
    LikenessOfDunes() { view_.image.width = 640, view_.image.height = 360; }

    [[nodiscard]] static Image drawn(const View& view, double shift = 0.0) {
        const auto context = gl::Context::create(gl::Backend::automatic);
        WorkerPool pool(2);
        const Snapshot first = dune_field(200, 0.0);
        Renderer renderer(*context, view, first, 1, pool);
        return renderer.render(dune_field(200, shift));
    }

    View view_;
};

TEST_F(LikenessOfDunes, MovedByAFiftiethOfAWavelengthIsDifferent) {
    const Comparison comparison = compare(drawn(view_), drawn(view_, 0.02));
    EXPECT_EQ(likeness(comparison), Likeness::different);
    EXPECT_GT(comparison.thumbnail.largest, close_limits.thumbnail);
}

TEST_F(LikenessOfDunes, WithoutAntialiasingIsNotTheSame) {
    View coarse = view_;
    coarse.image.supersampling = 1;
    const Comparison comparison = compare(drawn(view_), drawn(coarse));
    EXPECT_LT(likeness(comparison), Likeness::same_to_the_eye);
    EXPECT_LT(comparison.thumbnail.largest, close_limits.thumbnail);
}

TEST_F(LikenessOfDunes, UnderASunOneDegreeOnIsNotTheSame) {
    View later = view_;
    later.sun.azimuth += 1.0;
    EXPECT_LT(likeness(compare(drawn(view_), drawn(later))), Likeness::same_to_the_eye);
}

TEST(Difference, ShowsChangedPixelsAlone) {
    const Image image = some_picture(20, 10);
    Image changed = image;
    changed.row(4)[3 * 7] ^= 1U;
    const Image picture = difference_picture(image, changed);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 20; ++x) {
            const std::uint8_t* pixel = picture.row(y) + std::ptrdiff_t{3} * x;
            const bool red = pixel[0] > 100 && pixel[1] == 0 && pixel[2] == 0;
            EXPECT_EQ(red, x == 7 && y == 4) << x << ", " << y;
        }
    }
}

TEST(Compare, SeesWhatIsTransparent) {
    Image image = with_alpha(Image(16, 16));
    Image other = image;
    EXPECT_EQ(compare(image, other).changed, 0);
    other.alpha[40] = 100;
    EXPECT_EQ(compare(image, other).changed, 1);
    other.alpha[40] = image.alpha[40] = 0;
    other.rgb[120] = 255;
    EXPECT_EQ(compare(image, other).changed, 0) << "what nobody sees";
}

}  // namespace
}  // namespace fumon
