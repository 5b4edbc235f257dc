#include "picture/png.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

#include "base/error.h"
#include "files/input_file.h"
#include "files/png_guard.h"
#include "files/png_reader.h"

namespace fumon {

namespace {

constexpr int compression_level = 1;                     // a fifth of the time of level 6
constexpr std::size_t idat_size = std::size_t{1} << 18;  // bytes of one IDAT chunk
constexpr double metres_per_inch = 0.0254;

struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    PngFailure failure;

    Writer()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, remember_png_failure,
                                      ignore_png_warning)) {
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) {
            png_destroy_write_struct(&png, nullptr);
            throw Error("libpng cannot be started: out of memory");
        }
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

bool append(std::vector<std::uint8_t>& file, png_const_bytep bytes, std::size_t count) {
    try {
        file.insert(file.end(), bytes, bytes + count);
    } catch (const std::bad_alloc&) {
        return false;
    }
    return true;
}

void write_to_memory(png_structp png, png_bytep bytes, std::size_t count) {
    auto* file = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    if (!append(*file, bytes, count)) png_error(png, "out of memory");
}

void flush_nothing(png_structp /*png*/) {}

/// The rules of the PNG standard, clause 11.3.3.2.
void check_keyword(std::string_view keyword) {
    const auto printable = [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return (code >= 32 && code <= 126) || code >= 161;
    };
    const bool good = !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' &&
                      keyword.back() != ' ' && keyword.find("  ") == std::string_view::npos &&
                      std::all_of(keyword.begin(), keyword.end(), printable);
    if (!good)
        throw Error(
            fmt::format("'{}' cannot be a PNG keyword: 1 to 79 printable Latin-1 characters "
                        "without outer or double spaces",
                        keyword));
}

std::vector<png_text> text_chunks(const PictureText& texts) {
    std::vector<png_text> chunks;
    for (const auto& [keyword, text] : texts) {
        check_keyword(keyword);
        if (text.find('\0') != std::string::npos)
            throw Error(fmt::format(
                "the text of '{}' cannot be written to a PNG file: it contains a zero byte",
                keyword));
        png_text chunk{};
        chunk.compression = PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(keyword.c_str());  // libpng copies, and changes neither
        chunk.text = const_cast<char*>(text.c_str());
        chunk.itxt_length = text.size();
        chunks.push_back(chunk);
    }
    return chunks;
}

void check_image(const Image& image) {
    constexpr int longest_side = 65535;  // pixels; what the reader takes
    const bool sides = image.width > 0 && image.height > 0 && image.width <= longest_side &&
                       image.height <= longest_side;
    const auto bytes = 3LL * image.width * image.height;
    const bool opacities = !image.transparent() || 3 * image.alpha.size() == image.rgb.size();
    const bool deep = image.rgb16.empty() || image.rgb16.size() == image.rgb.size();
    if (!sides || !opacities || !deep || image.rgb.size() != static_cast<std::size_t>(bytes))
        throw Error(fmt::format("an image of {} × {} pixels cannot be written as PNG", image.width,
                                image.height));
}

/// Bytes that all are written before they are read.
struct Bytes {
    explicit Bytes(std::size_t count_)
        : memory(std::make_unique_for_overwrite<std::uint8_t[]>(count_)), count(count_) {}
    std::unique_ptr<std::uint8_t[]> memory;
    std::size_t count;
};

/// The rows as PNG's filter "sub" leaves them: each byte less the one a pixel before, and the
/// filter's number first.
Bytes filtered_rows(const Image& image) {
    const std::size_t channels = image.transparent() ? 4 : 3;
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t length = channels * width;
    Bytes rows((length + 1) * static_cast<std::size_t>(image.height));
    std::vector<std::uint8_t> joined(image.transparent() ? length : 0);
    std::uint8_t* out = rows.memory.get();
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* row = image.row(y);
        if (image.transparent()) {
            const std::uint8_t* alpha = image.alpha.data() + static_cast<std::size_t>(y) * width;
            for (std::size_t x = 0; x < width; ++x) {
                std::copy_n(row + 3 * x, 3, joined.data() + 4 * x);
                joined[4 * x + 3] = alpha[x];
            }
            row = joined.data();
        }
        *out++ = PNG_FILTER_VALUE_SUB;
        out = std::copy_n(row, channels, out);
        for (std::size_t i = channels; i < length; ++i)
            *out++ = static_cast<std::uint8_t>(row[i] - row[i - channels]);
    }
    return rows;
}

/// The same at 16 bits a channel, high bytes first.
Bytes filtered_deep_rows(const Image& image) {
    const std::size_t channels = image.transparent() ? 4 : 3;
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t length = 2 * channels * width;
    Bytes rows((length + 1) * static_cast<std::size_t>(image.height));
    std::uint8_t* out = rows.memory.get();
    std::vector<std::uint8_t> row(length);
    for (std::size_t first = 0; first < width * static_cast<std::size_t>(image.height);
         first += width) {
        std::size_t at = 0;
        const auto put = [&](unsigned level) {
            row[at++] = static_cast<std::uint8_t>(level >> 8U);
            row[at++] = static_cast<std::uint8_t>(level);
        };
        for (std::size_t x = first; x < first + width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) put(image.rgb16[3 * x + c]);
            if (image.transparent()) put(257U * image.alpha[x]);
        }
        *out++ = PNG_FILTER_VALUE_SUB;
        for (std::size_t i = 0; i < length; ++i) {
            const unsigned before = i < 2 * channels ? 0U : row[i - 2 * channels];
            *out++ = static_cast<std::uint8_t>(row[i] - before);
        }
    }
    return rows;
}

/// The pixels as the one zlib stream that IDAT chunks hold.
Bytes compressed(const Image& image) {
    const Bytes rows = image.rgb16.empty() ? filtered_rows(image) : filtered_deep_rows(image);
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(compression_level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    Bytes stream(libdeflate_zlib_compress_bound(compressor.get(), rows.count));
    stream.count = libdeflate_zlib_compress(compressor.get(), rows.memory.get(), rows.count,
                                            stream.memory.get(), stream.count);
    return stream;
}

void write_chunk(png_structp png, const char* name, std::span<const std::uint8_t> data) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), data.data(), data.size());
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, double dots_per_inch,
                                     const PictureText& texts) {
    check_image(image);
    std::vector<png_text> chunks = text_chunks(texts);
    const double dots_per_metre = std::round(dots_per_inch / metres_per_inch);
    const Bytes stream = compressed(image);
    const std::span<const std::uint8_t> pixels(stream.memory.get(), stream.count);
    std::vector<std::uint8_t> file;
    file.reserve(pixels.size() + 4096);
    Writer writer;
    const bool written = ends_without_png_error(writer.png, [&] {
        png_structp png = writer.png;
        png_set_write_fn(png, &file, write_to_memory, flush_nothing);
        png_set_user_limits(png, 65535, 65535);
        png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.width),
                     static_cast<png_uint_32>(image.height), image.rgb16.empty() ? 8 : 16,
                     image.transparent() ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
        if (dots_per_metre >= 1.0 && dots_per_metre <= 0x7FFFFFFF) {
            const auto density = static_cast<png_uint_32>(dots_per_metre);
            png_set_pHYs(png, writer.info, density, density, PNG_RESOLUTION_METER);
        }
        if (!chunks.empty())
            png_set_text(png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
        png_write_info(png, writer.info);
        for (std::size_t at = 0; at < pixels.size(); at += idat_size)
            write_chunk(png, "IDAT", pixels.subspan(at, std::min(idat_size, pixels.size() - at)));
        write_chunk(png, "IEND", {});
    });
    if (!written)
        throw Error(fmt::format("cannot encode a PNG image: {}", writer.failure.message.data()));
    return file;
}

PictureText read_png_texts(const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    return PngReader(bytes, file.string()).texts();
}

Image read_png(const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    return PngReader(bytes, file.string()).image();
}

}  // namespace fumon
