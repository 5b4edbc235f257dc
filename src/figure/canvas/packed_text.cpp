#include "figure/canvas/packed_text.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#include "figure/canvas/pdf_strings.h"

namespace fumon {

namespace {

constexpr std::string_view mark = "deflate:";
constexpr std::string_view base64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::optional<std::string> from_base64(std::string_view letters) {
    std::string bytes;
    std::uint32_t group = 0;
    unsigned bits = 0;
    while (letters.ends_with('=')) letters.remove_suffix(1);
    for (const char letter : letters) {
        const std::size_t value = base64.find(letter);
        if (value == std::string_view::npos) return std::nullopt;
        group = group << 6U | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 0xFFU);
    }
    return bytes;
}

}  // namespace

std::string base64_text(std::string_view bytes) {
    std::string letters;
    letters.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            letters += k > count ? '=' : base64[group >> (18U - 6U * k) & 63U];
    }
    return letters;
}

std::string deflated(std::string_view content) {
    constexpr int level = 9;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::string bytes(libdeflate_zlib_compress_bound(compressor.get(), content.size()), '\0');
    bytes.resize(libdeflate_zlib_compress(compressor.get(), content.data(), content.size(),
                                          bytes.data(), bytes.size()));
    return bytes;
}

std::string packed_text(std::string_view text) {
    return std::string(mark) + base64_text(deflated(text));
}

std::optional<std::string> unpacked_text(std::string_view letters) {
    if (!letters.starts_with(mark)) return std::nullopt;
    const auto bytes = from_base64(letters.substr(mark.size()));
    if (!bytes) return std::nullopt;
    std::size_t most = most_inflated;
    return inflated(*bytes, most);
}

}  // namespace fumon
