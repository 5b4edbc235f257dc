#include "picture/fingerprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "picture/baseline.h"
#include "picture/fingerprint_text.h"
#include "support/pictures.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::flat_picture;
using test::message_of;
using test::some_picture;
using test::TemporaryFolder;

/// A box's mean by the plain form: over its area in pixels, in long double.
long double plain_mean(const Image& image, int box_x, int box_y, int channel) {
    const long double left = static_cast<long double>(box_x) * image.width / Thumbnail::width;
    const long double right = static_cast<long double>(box_x + 1) * image.width / Thumbnail::width;
    const long double top = static_cast<long double>(box_y) * image.height / Thumbnail::height;
    const long double bottom =
        static_cast<long double>(box_y + 1) * image.height / Thumbnail::height;
    long double sum = 0;
    for (int y = 0; y < image.height; ++y) {
        const long double high =
            std::min<long double>(bottom, y + 1) - std::max<long double>(top, y);
        if (high <= 0) continue;
        for (int x = 0; x < image.width; ++x) {
            const long double wide =
                std::min<long double>(right, x + 1) - std::max<long double>(left, x);
            if (wide > 0) sum += high * wide * image.row(y)[3 * x + channel];
        }
    }
    return sum / ((right - left) * (bottom - top));
}

struct Size {
    int width;
    int height;
};

class ThumbnailOf : public ::testing::TestWithParam<Size> {};

TEST_P(ThumbnailOf, IsTheMeanOverEachBox) {
    const Image image = some_picture(GetParam().width, GetParam().height);
    const Thumbnail thumbnail = thumbnail_of(image);
    for (int y = 0; y < Thumbnail::height; ++y) {
        for (int x = 0; x < Thumbnail::width; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                ASSERT_NEAR(thumbnail.at(x, y, channel),
                            static_cast<double>(plain_mean(image, x, y, channel)), 1e-10)
                    << x << ", " << y << ", " << channel;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ThumbnailOf,
                         ::testing::Values(Size{64, 36}, Size{320, 180}, Size{101, 67},
                                           Size{32, 18}, Size{33, 17}, Size{7, 5}, Size{1, 1},
                                           Size{250, 3}),
                         [](const auto& test) {
                             return std::to_string(test.param.width) + "x" +
                                    std::to_string(test.param.height);
                         });

TEST(Fingerprint, AFlatPictureHasItsLevelEverywhere) {
    const Fingerprint print = fingerprint_of(flat_picture(101, 67, 255));
    for (const double level : print.thumbnail.levels) ASSERT_EQ(level, 255.0);
    EXPECT_EQ(print.difference_hash, 0U) << "nothing is darker than its right neighbour";
}

TEST(Fingerprint, OnePixelChangesTheHashAndItsBoxAlone) {
    Image image = some_picture(320, 180);
    const Thumbnail before = thumbnail_of(image);
    const Sha256 pixels = fingerprint_of(image).pixels;
    image.row(95)[3 * 207 + 1] ^= 0x80U;
    EXPECT_NE(fingerprint_of(image).pixels, pixels);
    const ThumbnailDifference difference = thumbnail_difference(before, thumbnail_of(image));
    EXPECT_NEAR(difference.largest, 128.0 / 100.0, 1e-12) << "boxes of 10 x 10 pixels";
    EXPECT_EQ(difference.x, 20);
    EXPECT_EQ(difference.y, 9);
}

TEST(Fingerprint, RoundsToTenths) {
    Thumbnail thumbnail;
    thumbnail.levels[0] = 12.34;
    thumbnail.levels[1] = 12.36;
    thumbnail.levels[2] = 254.97;
    const Thumbnail rounded = in_tenths(thumbnail);
    EXPECT_EQ(rounded.levels[0], 12.3);
    EXPECT_EQ(rounded.levels[1], 12.4);
    EXPECT_EQ(rounded.levels[2], 255.0);
}

TEST(Fingerprint, DifferenceHashFollowsTheLuminance) {
    Image rising(90, 80);
    for (int y = 0; y < rising.height; ++y) {
        for (int x = 0; x < rising.width; ++x) {
            const bool up = y < 40;  // brighter to the right above, to the left below
            rising.row(y)[3 * x + 1] = static_cast<std::uint8_t>(up ? 2 * x : 200 - 2 * x);
        }
    }
    EXPECT_EQ(difference_hash(rising), 0xFFFFFFFF00000000U);
}

/// What the text of a fingerprint says when it stands in a baseline.
Fingerprint read_back(const std::string& text) {
    const TemporaryFolder folder;
    const auto file =
        folder.file("b.toml", "[cases]\none = {scene = \"s.toml\"}\n[recorded.one]\n" + text);
    try {
        return read_baseline(file).records.at("one").fingerprint;
    } catch (const InputError& fault) {
        throw InputError(std::string(fault.what()).substr(folder.path().string().size() + 1));
    }
}

TEST(FingerprintText, ReadsBackTheSame) {
    const Fingerprint print = fingerprint_of(some_picture(101, 67));
    const std::string text = fingerprint_text(print);
    EXPECT_EQ(read_back(text), print);
    EXPECT_EQ(fingerprint_text(read_back(text)), text);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 3 * (2 + Thumbnail::height));
}

TEST(FingerprintText, SaysWhatIsWrongAndWhere) {
    const std::string good = fingerprint_text(fingerprint_of(some_picture(64, 36)));
    const auto fault = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return message_of<InputError>([&] { read_back(text); });
    };
    EXPECT_EQ(fault("size = [64, 36]", "size = [64]"),
              "b.toml:4:8: recorded.one.size takes [width, height]");
    EXPECT_EQ(fault("pixels = \"", "pixels = \"0"),
              "b.toml:5:10: recorded.one.pixels takes 64 hexadecimal digits; write the fingerprint "
              "again");
    EXPECT_EQ(
        fault("dhash = \"", "dhash = \"g"),
        "b.toml:6:9: recorded.one.dhash takes 16 hexadecimal digits; write the fingerprint again");
    const std::string start = "red = [\n  \"";
    for (const char* wrong : {"nan  ", "256.0", " -1.0", "1 1 1", "x    ", "1e3  "}) {
        std::string text = good;
        text.replace(text.find(start) + start.size(), 5, wrong);
        EXPECT_EQ(message_of<InputError>([&] { read_back(text); }),
                  "b.toml:7:7: recorded.one.red takes 18 rows of 32 levels from 0 to 255; write "
                  "the fingerprint again")
            << wrong;
    }
}

}  // namespace
}  // namespace fumon
