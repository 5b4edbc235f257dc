#include "picture/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

Image coloured(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
            pixel[0] = static_cast<std::uint8_t>(7 * x + y);
            pixel[1] = static_cast<std::uint8_t>(x * y);
            pixel[2] = static_cast<std::uint8_t>(255 - 3 * y);
        }
    }
    return image;
}

struct Chunk {
    std::string name;
    std::string data;
};

std::uint32_t big_endian(const std::vector<std::uint8_t>& file, std::size_t at) {
    return (std::uint32_t{file[at]} << 24U) | (std::uint32_t{file[at + 1]} << 16U) |
           (std::uint32_t{file[at + 2]} << 8U) | file[at + 3];
}

std::vector<Chunk> chunks_of(const std::vector<std::uint8_t>& file) {
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = big_endian(file, at);
        const auto begin = file.begin() + static_cast<std::ptrdiff_t>(at) + 4;
        chunks.push_back({std::string(begin, begin + 4),
                          std::string(begin + 4, begin + 4 + static_cast<std::ptrdiff_t>(length))});
        at += 12 + length;
    }
    return chunks;
}

/// The texts a picture of fumon's carries, and then some.
const PictureText texts{{"Software", "fumon 風紋"},
                        {"fumon scene", "title = \"Dünen\"\nseed = 1\n"},
                        {"empty", ""},
                        {"long", std::string(100'000, 'x')}};

TEST(Png, PixelsAndTextsComeBack) {
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {16, 16}, {31, 7}, {640, 361}}) {
        const Image image = coloured(width, height);
        write_file(folder / "a.png", encode_png(image, 300.0, texts));
        EXPECT_EQ(read_png(folder / "a.png"), image);
        EXPECT_EQ(read_png_texts(folder / "a.png"), texts);
    }
}

TEST(Png, SameInputGivesSameBytes) {
    EXPECT_EQ(encode_png(coloured(99, 50), 300.0, texts),
              encode_png(coloured(99, 50), 300.0, texts));
}

TEST(Png, HoldsTheChunksItShouldAndNoClock) {
    const auto chunks = chunks_of(encode_png(coloured(20, 10), 300.0, {{"Title", "é"}}));
    std::vector<std::string> names;
    for (const Chunk& chunk : chunks) names.push_back(chunk.name);
    EXPECT_EQ(names, (std::vector<std::string>{"IHDR", "sRGB", "pHYs", "iTXt", "IDAT", "IEND"}));
    EXPECT_EQ(chunks[0].data, std::string("\0\0\0\x14\0\0\0\x0A\x08\x02\0\0\0", 13));
    EXPECT_EQ(chunks[2].data,
              std::string("\0\0\x2E\x23\0\0\x2E\x23\x01", 9));  // 11811 dots a metre
    EXPECT_EQ(chunks[3].data, std::string("Title\0\0\0\0\0é", 12));
}

TEST(Png, LeavesOutASizeItDoesNotKnow) {
    for (const Chunk& chunk : chunks_of(encode_png(coloured(20, 10), 0.0, {})))
        EXPECT_NE(chunk.name, "pHYs");
}

TEST(Png, RefusesWhatCannotBeAKeywordOrText) {
    const Image image(1, 1);
    for (const std::string& keyword :
         {std::string(), std::string(80, 'k'), std::string(" a"), std::string("a "),
          std::string("a  b"), std::string("a\n"), std::string("a\0b", 3)})
        EXPECT_THROW(encode_png(image, 300.0, {{keyword, "x"}}), Error) << keyword;
    EXPECT_NO_THROW(encode_png(image, 300.0, {{std::string(79, 'k'), "x"}}));
    EXPECT_THROW(encode_png(image, 300.0, {{"k", std::string("a\0b", 3)}}), Error);
}

TEST(Png, RefusesAnImageThatIsNone) {
    EXPECT_EQ(message_of<Error>([] { encode_png(Image(), 300.0, {}); }),
              "an image of 0 × 0 pixels cannot be written as PNG");
    Image short_of_a_byte(4, 4);
    short_of_a_byte.rgb.pop_back();
    EXPECT_THROW(encode_png(short_of_a_byte, 300.0, {}), Error);
}

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// What another program may write: palette or grey, texts of every kind, some behind the picture.
std::string foreign_png(int colour, int interlace) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, append_bytes, nullptr);
    png_set_IHDR(png, info, 2, 1, 8, colour, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const std::vector<png_color> palette{{10, 20, 30}, {40, 50, 60}};
    if (colour == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 2);
    std::string keys[4] = {"plain", "packed", "international", "international packed"};
    std::string values[4] = {"caf\xE9", std::string(5000, '\xE9'), "café", std::string(5000, 'y')};
    const int kinds[4] = {PNG_TEXT_COMPRESSION_NONE, PNG_TEXT_COMPRESSION_zTXt,
                          PNG_ITXT_COMPRESSION_NONE, PNG_ITXT_COMPRESSION_zTXt};
    const auto chunk = [&](std::size_t i) {
        png_text text{};
        text.compression = kinds[i];
        text.key = keys[i].data();
        text.text = values[i].data();
        png_set_text(png, info, &text, 1);
    };
    chunk(0);
    chunk(3);
    png_write_info(png, info);
    chunk(1);
    chunk(2);
    std::vector<std::uint8_t> row{0, 1, 99, 200, 201, 202, 98, 7};
    png_bytep rows[1] = {row.data()};
    png_write_image(png, rows);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

TEST(Png, ReadsTextsOfEveryKindAndPlace) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.png", foreign_png(PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7));
    std::string packed;
    for (int i = 0; i < 5000; ++i) packed += "é";
    EXPECT_EQ(read_png_texts(file), (PictureText{{"plain", "café"},
                                                 {"international packed", std::string(5000, 'y')},
                                                 {"packed", packed},
                                                 {"international", "café"}}));
}

TEST(Png, ReadsPixelsOfEveryColourType) {
    const TemporaryFolder folder;
    const auto pixels = [&](int colour) {
        return read_png(folder.file("a.png", foreign_png(colour, PNG_INTERLACE_NONE))).rgb;
    };
    using Bytes = std::vector<std::uint8_t>;
    EXPECT_EQ(pixels(PNG_COLOR_TYPE_GRAY), (Bytes{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(pixels(PNG_COLOR_TYPE_PALETTE), (Bytes{10, 20, 30, 40, 50, 60}));
    EXPECT_EQ(pixels(PNG_COLOR_TYPE_RGB), (Bytes{0, 1, 99, 200, 201, 202}));
    EXPECT_EQ(pixels(PNG_COLOR_TYPE_RGB_ALPHA), (Bytes{0, 1, 99, 201, 202, 98}));
    EXPECT_EQ(pixels(PNG_COLOR_TYPE_GRAY_ALPHA), (Bytes{0, 0, 0, 99, 99, 99}));
}

TEST(Png, RefusesWhatIsNoPng) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.png", "GIF89a");
    EXPECT_EQ(message_of<InputError>([&] { read_png(file); }),
              file.string() + ": is not a PNG file; name one that is");
    EXPECT_THROW(read_png_texts(folder / "missing.png"), InputError);
}

TEST(Png, RefusesEveryTruncationAndFlippedBit) {
    const TemporaryFolder folder;
    const auto bytes = encode_png(coloured(5, 4), 300.0, {{"Title", "dunes"}});
    const std::string whole(bytes.begin(), bytes.end());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto file = folder.file("a.png", whole.substr(0, length));
        EXPECT_THROW(read_png_texts(file), InputError) << length;
        EXPECT_THROW(read_png(file), InputError) << length;
    }
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        const auto file = folder.file("a.png", damaged);
        EXPECT_THROW(read_png_texts(file), InputError) << "bit " << bit;
        EXPECT_THROW(read_png(file), InputError) << "bit " << bit;
    }
}

TEST(Png, Rounds16BitsAChannelTo8) {
    const TemporaryFolder folder;
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append_bytes, nullptr);
    png_set_IHDR(png, info, 1, 1, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    std::vector<std::uint8_t> row{1, 0x90};  // 400 of 65535, which is 1.56 of 255
    png_write_row(png, row.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    const auto file = folder.file("a.png", bytes);
    EXPECT_EQ(read_png(file).rgb, (std::vector<std::uint8_t>{2, 2, 2}));
}

TEST(Png, KeepsAlpha) {
    const test::TemporaryFolder folder;
    Image image(5, 3);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<std::uint8_t>(17 * i);
    const Sha256 opaque = pixel_hash(image);
    image = with_alpha(image);
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        image.alpha[i] = static_cast<std::uint8_t>(255 - 13 * i);
    const auto file = folder / "a.png";
    write_file(file, encode_png(image, 100.0, {{"Title", "a"}}));
    EXPECT_EQ(read_png(file), image);
    EXPECT_EQ(read_png_texts(file).front().second, "a");
    EXPECT_NE(pixel_hash(image), opaque);
    const Image white = composited_on(image, 255);
    EXPECT_FALSE(white.transparent());
    EXPECT_EQ(white.rgb[3], (image.rgb[3] * 242 + 255 * 13 + 127) / 255);
}

}  // namespace
}  // namespace fumon
