#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/peak_memory.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

void collect(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// A PNG file of the given kind from packed rows.
std::string png_file(int width, int height, int depth, int colour, std::vector<std::uint8_t> rows,
                     int interlace = PNG_INTERLACE_NONE, bool transparent = false) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, collect, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                 depth, colour, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const png_color black{0, 0, 0};
    if (colour == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, &black, 1);
    png_color_16 key{};
    if (transparent) png_set_tRNS(png, info, nullptr, 0, &key);
    png_write_info(png, info);
    std::vector<png_bytep> starts;
    const std::size_t row_bytes = rows.size() / static_cast<std::size_t>(height);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        starts.push_back(rows.data() + y * row_bytes);
    png_write_image(png, starts.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
}

constexpr std::string_view remedy = "; save it as a 16-bit grey PNG without alpha";
constexpr std::string_view range_remedy =
    "; write bed.heights = [low, high] in the scene or --heights low:high, the metres of black and "
    "of "
    "white";

TEST(PngHeights, Reads16BitGrey) {
    const TemporaryFolder folder;
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
        const auto file =
            folder.file("bed.png", png_file(2, 2, 16, PNG_COLOR_TYPE_GRAY,
                                            {0, 0, 0xFF, 0xFF, 0x33, 0x33, 0x01, 0x00}, interlace));
        const Terrain terrain = read_terrain(file, {{-10.0, 40.0}});
        EXPECT_EQ(terrain.heights(0, 1), -10.0);  // the top row is the northernmost
        EXPECT_EQ(terrain.heights(1, 1), 40.0);
        EXPECT_NEAR(terrain.heights(0, 0), 0.0, 1e-13);
        EXPECT_NEAR(terrain.heights(1, 0), -10.0 + 50.0 * 256 / 65535, 1e-13);
        EXPECT_EQ(terrain.dx, 0.0);
        EXPECT_EQ(terrain.note, "");
        EXPECT_TRUE(terrain.nodata.empty());
    }
}

TEST(PngHeights, Reads8BitGreyAndSaysSo) {
    const TemporaryFolder folder;
    const auto file = folder.file("bed.png", png_file(3, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255, 51}));
    const Terrain terrain = read_terrain(file, {{0.0, 100.0}});
    EXPECT_EQ(terrain.heights(1, 0), 100.0);
    EXPECT_NEAR(terrain.heights(2, 0), 20.0, 1e-13);
    EXPECT_EQ(
        terrain.note,
        "8-bit grey values: heights come in 256 levels, 0.3922 m apart; a 16-bit PNG is smoother");
}

TEST(PngHeights, RefusesOtherPictures) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& bytes) {
        const auto file = folder.file("bed.png", bytes);
        const std::string message = message_of<InputError>([&] {
            read_terrain(file, {{0.0, 1.0}});
        });
        return message.substr(std::min(message.size(), file.string().size()));
    };
    EXPECT_EQ(refusal(png_file(1, 1, 8, PNG_COLOR_TYPE_RGB, {1, 2, 3})),
              std::string(": is a colour image").append(remedy));
    EXPECT_EQ(refusal(png_file(1, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 4})),
              std::string(": is a colour image with alpha").append(remedy));
    EXPECT_EQ(refusal(png_file(1, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, {1, 2, 3, 4})),
              std::string(": is a grey image with alpha").append(remedy));
    EXPECT_EQ(refusal(png_file(1, 1, 8, PNG_COLOR_TYPE_PALETTE, {0})),
              std::string(": is a palette image").append(remedy));
    EXPECT_EQ(refusal(png_file(1, 1, 4, PNG_COLOR_TYPE_GRAY, {0})),
              std::string(": has 4-bit grey values").append(remedy));
    EXPECT_EQ(refusal(png_file(1, 1, 16, PNG_COLOR_TYPE_GRAY, {1, 2}, PNG_INTERLACE_NONE, true)),
              std::string(": has a transparent grey value").append(remedy));
}

TEST(PngHeights, SaysWhereTheRangeIsWritten) {
    const TemporaryFolder folder;
    const auto file = folder.file("bed.png", png_file(1, 1, 16, PNG_COLOR_TYPE_GRAY, {1, 2}));
    EXPECT_EQ(message_of<InputError>([&] { read_terrain(file, {}); }),
              (file.string() + ": a PNG image has no height scale").append(range_remedy));
    for (const std::vector<double>& range : {std::vector{1.0}, {2.0, 2.0}, {0.0, HUGE_VAL}})
        EXPECT_EQ(message_of<InputError>([&] { read_terrain(file, {range}); }),
                  (file.string() +
                   ": the height range of the PNG image is not two different finite numbers")
                      .append(range_remedy));
}

TEST(PngHeights, RefusesEveryTruncation) {
    const TemporaryFolder folder;
    const std::string whole =
        png_file(2, 2, 16, PNG_COLOR_TYPE_GRAY, {0, 0, 0xFF, 0xFF, 0x33, 0x33, 0x01, 0x00});
    for (std::size_t length = 8; length < whole.size(); ++length) {
        const auto file = folder.file("bed.png", whole.substr(0, length));
        EXPECT_EQ(message_of<InputError>([&] {
                      read_terrain(file, {{0.0, 1.0}});
                  }),
                  file.string() + ": is a damaged PNG file (the file ends early); make it again")
            << length;
    }
}

TEST(PngHeights, RefusesEveryFlippedBit) {
    const TemporaryFolder folder;
    const std::string whole =
        png_file(2, 2, 16, PNG_COLOR_TYPE_GRAY, {0, 0, 0xFF, 0xFF, 0x33, 0x33, 0x01, 0x00});
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        const auto file = folder.file("bed.png", damaged);
        EXPECT_THROW(read_terrain(file, {{0.0, 1.0}}), InputError) << "bit " << bit;
    }
}

/// CRC-32 as PNG defines it (standard, annex D), to forge a header.
std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

TEST(PngHeights, RefusesAHugePictureInAFewBytes) {
    const TemporaryFolder folder;
    const auto with_size = [](std::uint32_t width, std::uint32_t height) {
        std::string file = png_file(2, 2, 16, PNG_COLOR_TYPE_GRAY, {0, 0, 0, 0, 0, 0, 0, 0});
        const auto put = [&file](std::size_t offset, std::uint32_t value) {
            for (std::size_t i = 0; i < 4; ++i)
                file[offset + i] = static_cast<char>(value >> (24 - 8 * i));
        };
        put(16, width);
        put(20, height);
        put(29, crc32(std::string_view(file).substr(12, 17)));
        return file;
    };
    const auto refusal = [&](std::uint32_t width, std::uint32_t height) {
        const auto file = folder.file("bed.png", with_size(width, height));
        const std::string message = message_of<InputError>([&] {
            read_terrain(file, {{0.0, 1.0}});
        });
        return message.substr(std::min(message.size(), file.string().size()));
    };
    EXPECT_EQ(refusal(60000, 60000), ": has 60000 × 60000 pixels; at most 268435456 are read");
    EXPECT_EQ(refusal(10000, 10000),
              ": is a damaged PNG file (10000 × 10000 pixels in 68 bytes); make it again");
    EXPECT_EQ(refusal(100000, 2), ": is a damaged PNG file (Invalid IHDR data); make it again");
}

TEST(PngHeights, RefusesAHugeChunkInAFewBytes) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers have taken all address space beforehand";
#endif
    const TemporaryFolder folder;
    std::string bytes = png_file(2, 2, 16, PNG_COLOR_TYPE_GRAY, {0, 0, 0, 0, 0, 0, 0, 0});
    constexpr std::size_t behind_header = 33;
    bytes.insert(behind_header, std::string("\x60\0\0\0iTXt", 8));
    const auto file = folder.file("bed.png", bytes);
    const std::size_t before = test::peak_memory();
    EXPECT_EQ(message_of<InputError>([&] {
                  read_terrain(file, {{0.0, 1.0}});
              }),
              file.string() + ": is a damaged PNG file (the file ends early); make it again");
    EXPECT_LT(test::peak_memory() - before, std::size_t{64} << 20U);
}

}  // namespace
}  // namespace fumon
