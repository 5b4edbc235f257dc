#include "picture/stills/picture_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "base/error.h"
#include "files/atomic_file.h"
#include "picture/stills/jpeg.h"
#include "picture/stills/webp.h"
#include "picture/stills/xmp.h"
#include "support/command.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

Image shaded(int width, int height, bool transparent) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = image.row(y) + 3 * x;
            pixel[0] = static_cast<std::uint8_t>(40 + 2 * x);
            pixel[1] = static_cast<std::uint8_t>(200 - 2 * y);
            pixel[2] = static_cast<std::uint8_t>(90 + x - y);
        }
    }
    if (!transparent) return image;
    image = with_alpha(std::move(image));
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        image.alpha[i] = static_cast<std::uint8_t>(i % 4 == 0 ? 0 : 255);
    return image;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

PictureText scene_texts(std::size_t length) {
    std::string scene = "title = \"5 < 6 & 7 > 6 'ÄÖ' ]]>\"\n\t# tab\r\n";
    while (scene.size() < length) scene += "key = \"&amp; <value>\"\n";
    return {{"Title", "Dunes & <ripples>"},
            {"Software", "fumon 1.2.3"},
            {"fumon:scene", scene},
            {"fumon:pixels-sha256", "00ff"}};
}

int largest_loss(const Image& a, const Image& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    return largest;
}

TEST(PictureFile, HasTheSameTextsInEveryFormatAlsoLongOnes) {
    const Image image = shaded(40, 30, false);
    for (const std::size_t length : {std::size_t{0}, std::size_t{70'000}, std::size_t{300'000}}) {
        for (const char* name : {"a.png", "a.jpg", "a.webp"}) {
            const TemporaryFolder folder;
            const auto file = folder.path() / name;
            write_file(file,
                       encode_picture(image, picture_format(file), {}, 300, scene_texts(length)));
            PictureText read = read_picture_texts(file);
            PictureText wanted = scene_texts(length);
            std::ranges::sort(read);
            std::ranges::sort(wanted);
            EXPECT_EQ(read, wanted) << name << " " << length;
        }
    }
}

TEST(PictureFile, PixelsComeBackWithinTheLossOfTheFormat) {
    const Image image = shaded(67, 41, false);
    const auto jpeg = encode_picture(image, PictureFormat::jpeg, {}, 300, {});
    EXPECT_LE(largest_loss(decode_jpeg(text_of(jpeg), "a.jpg"), image), 4);
    const auto lossy = encode_picture(image, PictureFormat::webp, {}, 300, {});
    EXPECT_LE(largest_loss(decode_webp(text_of(lossy), "a.webp"), image), 12);
    const Image transparent = shaded(67, 41, true);
    const auto whole = encode_picture(transparent, PictureFormat::webp, {92, true}, 300, {});
    EXPECT_EQ(decode_webp(text_of(whole), "a.webp"), transparent);
    const auto coarse = encode_picture(transparent, PictureFormat::webp, {50, false}, 300, {});
    EXPECT_EQ(decode_webp(text_of(coarse), "a.webp").alpha, transparent.alpha);
    EXPECT_LT(encode_picture(image, PictureFormat::jpeg, {30, false}, 300, {}).size(), jpeg.size());
    EXPECT_EQ(encode_picture(image, PictureFormat::jpeg, {}, 300, {}), jpeg);
}

TEST(PictureFile, JpegPutsWhatCanBeSeenThroughOnWhite) {
    Image image = with_alpha(Image(16, 16));
    std::ranges::fill(image.alpha, std::uint8_t{0});
    const auto jpeg = encode_picture(image, PictureFormat::jpeg, {}, 300, {});
    const Image read = decode_jpeg(text_of(jpeg), "a.jpg");
    EXPECT_TRUE(std::ranges::all_of(read.rgb, [](std::uint8_t level) { return level == 255; }));
}

TEST(PictureFile, StatesDotsPerInchAndSrgb) {
    const auto jpeg = text_of(encode_jpeg(shaded(8, 8, false), 92, 150, {}));
    EXPECT_EQ(jpeg.substr(6, 4), "JFIF");
    EXPECT_EQ(jpeg.substr(13, 5), std::string("\x01\x00\x96\x00\x96", 5));
    for (const std::string& file :
         {jpeg, text_of(encode_webp(shaded(8, 8, false), true, 92, 150, {}))}) {
        const std::string srgb("\x01\xA0\x03\x00\x01\x00\x00\x00\x01\x00\x00\x00", 12);
        EXPECT_NE(file.find(srgb), std::string::npos);
        const std::string density("\xF0\x49\x02\x00\xE8\x03\x00\x00", 8);  // 150000 / 1000
        EXPECT_NE(file.find(density), std::string::npos);
    }
}

TEST(PictureFile, RefusesWhatTheFormatCannotHold) {
    Image deep = shaded(8, 8, false);
    deep.rgb16.resize(deep.rgb.size());
    EXPECT_EQ(
        message_of<InputError>([&] { encode_picture(deep, PictureFormat::jpeg, {}, 96, {}); }),
        "JPEG holds 8 bits a channel, not 16; write a PNG");
    EXPECT_EQ(message_of<InputError>([&] {
                  encode_picture(deep, PictureFormat::webp, {92, true}, 96, {});
              }),
              "WebP holds 8 bits a channel, not 16; write a PNG");
    EXPECT_EQ(message_of<InputError>([&] {
                  encode_picture(shaded(8, 8, false), PictureFormat::jpeg, {92, true}, 96, {});
              }),
              "JPEG is always lossy; write a WebP or PNG");
    EXPECT_EQ(
        message_of<InputError>([&] { encode_webp(Image(16384, 1), false, 92, 96, {}); }),
        "a picture of 16384 × 1 pixels is too large for WebP, which holds 16383 on a side; write "
        "a PNG");
}

/// Every shorter file, and every file with a changed byte, is read or refused in one line.
TEST(PictureFile, DamagedFilesAreRefused) {
    const Image image = shaded(24, 16, false);
    const TemporaryFolder folder;
    for (const char* name : {"a.jpg", "a.webp"}) {
        const auto file = folder.path() / name;
        const std::string whole =
            text_of(encode_picture(image, picture_format(file), {}, 96, scene_texts(0)));
        for (std::size_t size = 0; size < whole.size(); size += 7) {
            write_file(file, whole.substr(0, size));
            EXPECT_THROW(read_picture_texts(file), InputError) << name << " " << size;
            EXPECT_THROW(read_picture(file), InputError) << name << " " << size;
        }
        for (std::size_t at = 0; at < whole.size(); at += 3) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ 0x5A);
            write_file(file, changed);
            for (const bool pixels : {false, true}) {
                try {
                    if (pixels) {
                        read_picture(file);
                    } else {
                        read_picture_texts(file);
                    }
                } catch (const InputError& refusal) {
                    EXPECT_EQ(std::string(refusal.what()).find('\n'), std::string::npos);
                }
            }
        }
    }
}

TEST(Xmp, IsReadAsOtherProgramsWriteIt) {
    const PictureText wanted{
        {"Software", "fumon 1"}, {"fumon:step", "7"}, {"fumon:scene", "a\n<b>"}};
    EXPECT_EQ(texts_of_xmp("<rdf:Description xmp:CreatorTool='fumon 1' fumon:step=\"7\"\n "
                           "fumon:scene='a&#xA;&lt;b&gt;' other:key=\"x\"/>"),
              wanted);
    EXPECT_TRUE(texts_of_xmp("<a b='c").empty());
    EXPECT_TRUE(texts_of_xmp("no XMP").empty());
}

/// As the standard asks; md5sum is of another hand.
TEST(Xmp, AnExtensionIsNamedByItsMd5) {
    PictureText texts{{"Software", "fumon 1"}};
    texts.emplace_back("fumon:scene", "a \"tab\"\tand\nlines & <b>" + std::string(3000, 'x'));
    const XmpParts parts = xmp_parts(texts, 1500);
    const TemporaryFolder folder;
    write_file(folder / "extension", parts.extension);
    std::string digits =
        test::run_command("md5sum < '" + (folder / "extension").string() + "'").words.substr(0, 32);
    for (char& digit : digits) digit = static_cast<char>(std::toupper(digit));
    EXPECT_EQ(parts.guid, digits);
    EXPECT_EQ(extension_of_xmp(parts.packet), digits);
    EXPECT_EQ(texts_of_xmp(parts.extension), (PictureText{texts.back()}));
}

}  // namespace
}  // namespace fumon
