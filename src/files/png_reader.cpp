#include "files/png_reader.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <utility>

#include "base/error.h"
#include "files/png_guard.h"

namespace fumon {

namespace {

constexpr png_uint_32 longest_side = 65535;                 // pixels
constexpr std::size_t most_pixels = std::size_t{1} << 28;   // 805 MB as RGB
constexpr std::size_t largest_text = std::size_t{1} << 22;  // bytes of one unpacked text chunk
constexpr png_uint_32 most_chunks = 100;        // texts and unknown chunks that are kept
constexpr std::size_t best_compression = 1032;  // unpacked / packed bytes; the limit of deflate

/// The part of the file that libpng has not asked for yet.
struct Input {
    std::string_view left;
};

void read_from_memory(png_structp png, png_bytep target, std::size_t count) {
    auto* input = static_cast<Input*>(png_get_io_ptr(png));
    if (count > input->left.size()) png_error(png, "the file ends early");
    std::memcpy(target, input->left.data(), count);
    input->left.remove_prefix(count);
}

PngColour colour_of(int type) {
    switch (type) {
        case PNG_COLOR_TYPE_GRAY:
            return PngColour::grey;
        case PNG_COLOR_TYPE_GRAY_ALPHA:
            return PngColour::grey_alpha;
        case PNG_COLOR_TYPE_PALETTE:
            return PngColour::palette;
        case PNG_COLOR_TYPE_RGB:
            return PngColour::rgb;
        default:
            return PngColour::rgb_alpha;
    }
}

std::string utf8_of_latin1(std::string_view latin1) {
    std::string utf8;
    utf8.reserve(latin1.size());
    for (const char c : latin1) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xC0U | (code >> 6U));
            utf8 += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }
    return utf8;
}

using Texts = std::vector<std::pair<std::string, std::string>>;

Texts texts_of(png_structp png, png_infop place) {
    png_textp chunks = nullptr;
    int count = 0;
    png_get_text(png, place, &chunks, &count);
    Texts texts;
    for (int i = 0; i < count; ++i) {
        const png_text& chunk = chunks[i];
        const bool international = chunk.compression >= PNG_ITXT_COMPRESSION_NONE;
        const std::size_t length = international ? chunk.itxt_length : chunk.text_length;
        const std::string_view text(chunk.text, length);
        texts.emplace_back(utf8_of_latin1(chunk.key),
                           international ? std::string(text) : utf8_of_latin1(text));
    }
    return texts;
}

/// Whether every chunk up to the last lies within the file. libpng asks for the memory of a chunk
/// before it looks whether that much is there.
bool chunks_fit(std::string_view bytes) {
    constexpr std::size_t signature = 8;     // bytes
    constexpr std::size_t around_data = 12;  // length, type and checksum of a chunk
    for (std::string_view left = bytes.substr(signature); left.size() >= around_data;) {
        const auto at = [left](std::size_t i) {
            return std::size_t{static_cast<unsigned char>(left[i])};
        };
        const std::size_t length = at(0) << 24U | at(1) << 16U | at(2) << 8U | at(3);
        if (length > left.size() - around_data) return false;
        if (left.substr(4, 4) == "IEND") return true;
        left.remove_prefix(length + around_data);
    }
    return false;
}

}  // namespace

struct PngReader::Parts {
    std::string name;
    Input input;
    std::size_t file_size = 0;
    PngFailure failure;
    png_structp png = nullptr;
    png_infop head = nullptr;
    png_infop tail = nullptr;  ///< texts may also stand behind the picture
    PngInfo info;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() { png_destroy_read_struct(&png, &head, &tail); }
};

bool is_png(std::string_view bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1A\n");
}

PngReader::PngReader(std::string_view bytes, std::string name) : parts_(std::make_unique<Parts>()) {
    Parts& parts = *parts_;
    parts.name = std::move(name);
    parts.input.left = bytes;
    parts.file_size = bytes.size();
    if (!is_png(bytes))
        throw InputError(fmt::format("{}: is not a PNG file; name one that is", parts.name));
    if (!chunks_fit(bytes))
        throw InputError(fmt::format(
            "{}: is a damaged PNG file (the file ends early); make it again", parts.name));
    parts.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &parts.failure, remember_png_failure,
                                       ignore_png_warning);
    if (parts.png == nullptr) throw Error("libpng cannot be started: out of memory");
    const bool read = ends_without_png_error(parts.png, [&parts] {
        parts.head = png_create_info_struct(parts.png);
        parts.tail = png_create_info_struct(parts.png);
        if (parts.head == nullptr || parts.tail == nullptr) png_error(parts.png, "out of memory");
        png_set_read_fn(parts.png, &parts.input, read_from_memory);
        png_set_crc_action(parts.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_set_user_limits(parts.png, longest_side, longest_side);
        png_set_chunk_malloc_max(parts.png, largest_text);
        png_set_chunk_cache_max(parts.png, most_chunks);
        png_read_info(parts.png, parts.head);
        parts.info.width = static_cast<int>(png_get_image_width(parts.png, parts.head));
        parts.info.height = static_cast<int>(png_get_image_height(parts.png, parts.head));
        parts.info.bit_depth = png_get_bit_depth(parts.png, parts.head);
        parts.info.colour = colour_of(png_get_color_type(parts.png, parts.head));
        parts.info.transparent_colour = png_get_valid(parts.png, parts.head, PNG_INFO_tRNS) != 0;
    });
    if (!read) refuse_damaged();

    const auto width = static_cast<std::size_t>(parts.info.width);
    const auto height = static_cast<std::size_t>(parts.info.height);
    if (width * height > most_pixels)
        throw InputError(fmt::format("{}: has {} × {} pixels; at most {} are read", parts.name,
                                     width, height, most_pixels));
    const std::size_t stored = png_get_rowbytes(parts.png, parts.head) * height;
    if (stored / best_compression > parts.file_size)
        throw InputError(
            fmt::format("{}: is a damaged PNG file ({} × {} pixels in {} bytes); make it again",
                        parts.name, width, height, parts.file_size));
}

PngReader::~PngReader() = default;

const PngInfo& PngReader::info() const {
    return parts_->info;
}

void PngReader::refuse_damaged() const {
    if (std::strstr(parts_->failure.message.data(), "memory") != nullptr) throw std::bad_alloc();
    throw InputError(fmt::format("{}: is a damaged PNG file ({}); make it again", parts_->name,
                                 parts_->failure.message.data()));
}

std::vector<std::uint8_t> PngReader::read_rows() {
    Parts& parts = *parts_;
    if (!ends_without_png_error(parts.png, [&parts] {
            png_set_interlace_handling(parts.png);
            png_read_update_info(parts.png, parts.head);
        }))
        refuse_damaged();
    const auto height = static_cast<std::size_t>(parts.info.height);
    const std::size_t row_bytes = png_get_rowbytes(parts.png, parts.head);
    std::vector<std::uint8_t> bytes(row_bytes * height);
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = bytes.data() + y * row_bytes;
    if (!ends_without_png_error(parts.png, [&parts, &rows] {
            png_read_image(parts.png, rows.data());
            png_read_end(parts.png, parts.tail);
        }))
        refuse_damaged();
    return bytes;
}

std::vector<std::uint8_t> PngReader::samples() {
    return read_rows();
}

Image PngReader::image() {
    Parts& parts = *parts_;
    const bool transparent =
        parts.info.colour == PngColour::rgb_alpha || parts.info.colour == PngColour::grey_alpha;
    if (!ends_without_png_error(parts.png, [&parts, transparent] {
            png_set_expand(parts.png);
            png_set_gray_to_rgb(parts.png);
            png_set_scale_16(parts.png);
            if (!transparent) png_set_strip_alpha(parts.png);
        }))
        refuse_damaged();
    Image image;
    image.width = parts.info.width;
    image.height = parts.info.height;
    std::vector<std::uint8_t> rows = read_rows();
    if (!transparent) {
        image.rgb = std::move(rows);
        return image;
    }
    image = with_alpha(Image(image.width, image.height));
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
        std::copy_n(rows.data() + 4 * i, 3, image.rgb.data() + 3 * i);
        image.alpha[i] = rows[4 * i + 3];
    }
    return image;
}

std::vector<std::pair<std::string, std::string>> PngReader::texts() {
    Parts& parts = *parts_;
    // libpng finds what stands behind the picture only by reading the picture.
    std::vector<std::uint8_t> row(png_get_rowbytes(parts.png, parts.head));
    const int height = parts.info.height;
    if (!ends_without_png_error(parts.png, [&parts, &row, height] {
            const int passes = png_set_interlace_handling(parts.png);
            for (int i = 0; i < passes * height; ++i) png_read_row(parts.png, row.data(), nullptr);
            png_read_end(parts.png, parts.tail);
        }))
        refuse_damaged();
    Texts all = texts_of(parts.png, parts.head);
    for (auto& text : texts_of(parts.png, parts.tail)) all.push_back(std::move(text));
    return all;
}

std::vector<std::pair<std::string, std::string>> PngReader::texts_before_picture() const {
    return texts_of(parts_->png, parts_->head);
}

}  // namespace fumon
