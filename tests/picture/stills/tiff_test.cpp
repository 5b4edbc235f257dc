#include "picture/stills/tiff.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "picture/pixels/srgb_profile.h"
#include "picture/stills/cmyk.h"
#include "picture/stills/picture_file.h"
#include "support/command.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

/// Colours that differ from pixel to pixel; opacities likewise.
Image tiff_sample(bool has_transparency) {
    Image image(37, 23);
    std::uint8_t level = 7;
    for (std::uint8_t& value : image.rgb) value = level = static_cast<std::uint8_t>(level * 5 + 11);
    if (has_transparency) {
        image = with_alpha(image);
        image.alpha[3] = 0;
        image.alpha[4] = 255;
    }
    return image;
}

PictureText tiff_sample_texts() {
    return {{"Title", "風紋 & <1 mm>"}, {"Software", "fumon 1"}, {"fumon:scene", "a = \"b\"\r\n"}};
}

std::string text_of_tiff(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

TEST(TiffFile, HasPixelsTextsAndDotsPerInch) {
    for (const bool has_transparency : {false, true}) {
        const Image image = tiff_sample(has_transparency);
        const auto bytes = encode_tiff(image, 600.0, tiff_sample_texts());
        EXPECT_EQ(bytes, encode_tiff(image, 600.0, tiff_sample_texts()));
        const std::string file = text_of_tiff(bytes);
        EXPECT_TRUE(is_tiff(file));
        EXPECT_EQ(tiff_texts(file, "a.tif"), tiff_sample_texts());
        const Image read = decode_tiff(file, "a.tif");
        EXPECT_EQ(read.alpha, image.alpha);
        if (!has_transparency) {
            EXPECT_EQ(read.rgb, image.rgb);
        }
        const TemporaryFolder folder;
        const std::string path = folder.file("a.tif", file).string();
        TIFF* const tiff = TIFFOpen(path.c_str(), "r");
        ASSERT_NE(tiff, nullptr);
        float across = 0.0F;
        std::uint16_t unit = 0;
        std::uint16_t compression = 0;
        std::uint32_t size = 0;
        const void* profile = nullptr;
        TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across);
        TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
        TIFFGetField(tiff, TIFFTAG_COMPRESSION, &compression);
        ASSERT_EQ(TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile), 1);
        EXPECT_EQ(across, 600.0F);
        EXPECT_EQ(unit, RESUNIT_INCH);
        EXPECT_EQ(compression, COMPRESSION_LZW);
        EXPECT_EQ(std::string(static_cast<const char*>(profile), size), srgb_profile());
        TIFFClose(tiff);
    }
    EXPECT_TRUE(
        tiff_texts(text_of_tiff(encode_tiff(tiff_sample(false), 72.0, {})), "a.tif").empty());
}

TEST(TiffFile, RefusesWhatItCannotRead) {
    const std::string file = text_of_tiff(encode_tiff(tiff_sample(false), 300.0, {}));
    for (const std::size_t size : {std::size_t{5}, std::size_t{20}, std::size_t{300}}) {
        const std::string cut = file.substr(0, size);
        EXPECT_NE(message_of<InputError>([&] { decode_tiff(cut, "a.tif"); }).find("damaged TIFF"),
                  std::string::npos)
            << size;
    }
    std::string large = file;  // a width of 2^30 in place of 37
    const std::size_t at = large.find(std::string("\0\1\3\0\1\0\0\0\x25\0", 10));
    if (at != std::string::npos) {
        large[at + 8] = 0;
        large[at + 9] = 0x7F;
        EXPECT_THROW(decode_tiff(large, "a.tif"), InputError);
    }
    EXPECT_EQ(picture_format("a.TIFF"), PictureFormat::tiff);
    Image deep(4, 4);
    deep.rgb16.resize(deep.rgb.size());
    EXPECT_EQ(
        message_of<InputError>([&] { encode_picture(deep, PictureFormat::tiff, {}, 96, {}); }),
        "TIFF holds 8 bits a channel, not 16; write a PNG");
}

/// Ghostscript ships one.
std::string printers_profile() {
    const std::filesystem::path file = "/usr/share/color/icc/ghostscript/default_cmyk.icc";
    return std::filesystem::exists(file) ? test::bytes_of(file) : "";
}

TEST(TiffFile, HasTheInksOfAPrintersProfile) {
    EXPECT_EQ(message_of<InputError>([] { check_cmyk_profile("no"); }),
              "is not an ICC profile; name the profile of a CMYK printer");
    EXPECT_EQ(message_of<InputError>([] { check_cmyk_profile(srgb_profile()); }),
              "is an ICC profile, but not that of a CMYK printer");
    const std::string profile = printers_profile();
    if (profile.empty()) GTEST_SKIP() << "no profile of inks is here (it comes with libgs-common)";
    check_cmyk_profile(profile);
    Image image(3, 1);
    image.rgb = {255, 255, 255, 0, 0, 0, 255, 0, 0};
    const std::vector<std::uint8_t> inks = cmyk_of(image, profile);
    ASSERT_EQ(inks.size(), 12U);
    EXPECT_EQ(*std::max_element(inks.begin(), inks.begin() + 4), 0) << "none on white";
    EXPECT_GT(inks[7], 150) << "black is mostly black ink";
    EXPECT_LT(inks[8], 60) << "red has little cyan";
    EXPECT_GT(std::min(inks[9], inks[10]), 150) << "and much magenta and yellow";
    const std::string file = text_of_tiff(encode_tiff(image, 300.0, tiff_sample_texts(), profile));
    EXPECT_EQ(tiff_texts(file, "a.tif"), tiff_sample_texts());
    EXPECT_EQ(message_of<InputError>([&] { decode_tiff(file, "a.tif"); }),
              "a.tif: holds colours for print (CMYK); save it with RGB colours");
    if (test::run_command("command -v tiffinfo").status != 0) return;
    const TemporaryFolder folder;
    const test::Spoken info = test::run_command("tiffinfo " + folder.file("a.tif", file).string());
    for (const char* part :
         {"Photometric Interpretation: separated", "Resolution: 300, 300 pixels/inch",
          "Compression Scheme: LZW", "ICC Profile: <present>"})
        EXPECT_NE(info.words.find(part), std::string::npos) << part << info.words;
}

}  // namespace
}  // namespace fumon
