#include "film/cache/cached_picture.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>

#include "base/error.h"

namespace fumon {

namespace {

constexpr std::size_t picture_channels = 3;
constexpr int quick_level = 1;
constexpr std::int32_t most_side = 1 << 16;

/// What stands before the compressed pixels. The file is read on the machine that wrote it alone,
/// so that numbers are as the processor has them.
struct CacheHeader {
    std::array<char, 16> mark{};
    Sha256 key{};
    std::int32_t width = 0;
    std::int32_t height = 0;
    double low = 0.0;
    double high = 0.0;
    std::uint8_t values_below = 0;
    std::uint8_t values_above = 0;
    std::uint8_t kept = 0;
    std::uint8_t transparent = 0;
    std::uint8_t unused[4]{};
};

constexpr std::array<char, 16> cache_mark{'f', 'u', 'm', 'o', 'n', ' ', 'p', 'i',
                                          'c', 't', 'u', 'r', 'e', ' ', '1', '\n'};

/// Replaces each value of a row but the first ones by how much it differs from that of the pixel
/// before.
void take_differences(std::uint8_t* row, std::size_t count, std::size_t channels) {
    for (std::size_t i = count; i-- > channels;)
        row[i] = static_cast<std::uint8_t>(row[i] - row[i - channels]);
}

void add_differences(std::uint8_t* row, std::size_t count, std::size_t channels) {
    for (std::size_t i = channels; i < count; ++i)
        row[i] = static_cast<std::uint8_t>(row[i] + row[i - channels]);
}

template <class Change>
void each_row(std::uint8_t* values, const Image& image, std::size_t channels, Change change) {
    const std::size_t row = channels * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y)
        change(values + row * static_cast<std::size_t>(y), row, channels);
}

}  // namespace

std::vector<std::uint8_t> encode_cached_picture(const CachedPicture& picture, const Sha256& key) {
    const Image& image = picture.image;
    CacheHeader header;
    header.mark = cache_mark;
    header.key = key;
    header.width = image.width;
    header.height = image.height;
    header.low = picture.colours.low;
    header.high = picture.colours.high;
    header.values_below = picture.colours.values_below ? 1 : 0;
    header.values_above = picture.colours.values_above ? 1 : 0;
    header.kept = picture.colours.kept ? 1 : 0;
    header.transparent = image.transparent() ? 1 : 0;
    std::vector<std::uint8_t> pixels(image.rgb.size() + image.alpha.size());
    std::ranges::copy(image.rgb, pixels.begin());
    std::ranges::copy(image.alpha, pixels.begin() + static_cast<std::ptrdiff_t>(image.rgb.size()));
    each_row(pixels.data(), image, picture_channels, take_differences);
    if (image.transparent()) each_row(pixels.data() + image.rgb.size(), image, 1, take_differences);
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(quick_level), libdeflate_free_compressor);
    if (!compressor) throw Error("not enough memory to compress a picture");
    std::vector<std::uint8_t> file(sizeof header +
                                   libdeflate_zlib_compress_bound(compressor.get(), pixels.size()));
    std::memcpy(file.data(), &header, sizeof header);
    file.resize(sizeof header + libdeflate_zlib_compress(compressor.get(), pixels.data(),
                                                         pixels.size(), file.data() + sizeof header,
                                                         file.size() - sizeof header));
    return file;
}

std::optional<CachedPicture> decode_cached_picture(std::span<const std::uint8_t> file,
                                                   const Sha256& key) {
    CacheHeader header;
    if (file.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, file.data(), sizeof header);
    const bool fits = header.mark == cache_mark && header.key == key && header.width > 0 &&
                      header.height > 0 && header.width < most_side && header.height < most_side;
    if (!fits) return std::nullopt;
    CachedPicture picture{Image(header.width, header.height),
                          {header.low, header.high, header.values_below != 0,
                           header.values_above != 0, header.kept != 0}};
    Image& image = picture.image;
    if (header.transparent != 0) image = with_alpha(std::move(image));
    std::vector<std::uint8_t> pixels(image.rgb.size() + image.alpha.size());
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!decompressor) return std::nullopt;
    // It compares the sum that ends the stream with that of what it has read.
    if (libdeflate_zlib_decompress(decompressor.get(), file.data() + sizeof header,
                                   file.size() - sizeof header, pixels.data(), pixels.size(),
                                   nullptr) != LIBDEFLATE_SUCCESS)
        return std::nullopt;
    each_row(pixels.data(), image, picture_channels, add_differences);
    if (image.transparent()) each_row(pixels.data() + image.rgb.size(), image, 1, add_differences);
    const auto end_of_colours = pixels.begin() + static_cast<std::ptrdiff_t>(image.rgb.size());
    std::copy(pixels.begin(), end_of_colours, image.rgb.begin());
    std::copy(end_of_colours, pixels.end(), image.alpha.begin());
    return picture;
}

}  // namespace fumon
