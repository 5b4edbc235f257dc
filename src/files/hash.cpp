#include "files/hash.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

Sha256 pixel_hash(const Image& image) {
    Sha256Stream hasher;
    hasher.add_little_endian(static_cast<std::uint32_t>(image.width));
    hasher.add_little_endian(static_cast<std::uint32_t>(image.height));
    hasher.add(image.rgb.data(), image.rgb.size());
    hasher.add(image.alpha.data(), image.alpha.size());
    return hasher.finish();
}

Sha256 text_hash(std::string_view text) {
    Sha256Stream hasher;
    hasher.add(text.data(), text.size());
    return hasher.finish();
}

Sha256 bytes_hash(std::span<const std::uint8_t> bytes) {
    Sha256Stream hasher;
    hasher.add(bytes.data(), bytes.size());
    return hasher.finish();
}

Sha256 file_hash(const std::filesystem::path& file) {
    Sha256Stream hasher;
    stream_input_file(file, std::numeric_limits<std::int64_t>::max(),
                      [&](std::string_view bytes) { hasher.add(bytes.data(), bytes.size()); });
    return hasher.finish();
}

bool has_hash(const std::filesystem::path& file, const std::string& hash) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) return false;
    try {
        return hex(file_hash(file)) == hash;
    } catch (const Error&) {
        return false;  // it cannot be read
    }
}

std::string hex(const Sha256& hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    text.reserve(2 * hash.size());
    for (const std::uint8_t byte : hash) {
        text += digits[byte >> 4U];
        text += digits[byte & 0xFU];
    }
    return text;
}

}  // namespace fumon
