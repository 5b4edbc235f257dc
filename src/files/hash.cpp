#include "files/hash.h"

#include <bit>
#include <cstdint>
#include <span>

#include "files/input_file.h"

namespace fumon {

namespace {

void add_doubles(Sha256Stream& hasher, std::span<const double> values) {
    if constexpr (std::endian::native == std::endian::little) {
        hasher.add(values.data(), values.size_bytes());
    } else {
        for (const double value : values)
            hasher.add_little_endian(std::bit_cast<std::uint64_t>(value));
    }
}

}  // namespace

Sha256 pixel_hash(const Image& image) {
    Sha256Stream hasher;
    hasher.add_little_endian(static_cast<std::uint32_t>(image.width));
    hasher.add_little_endian(static_cast<std::uint32_t>(image.height));
    hasher.add(image.rgb.data(), image.rgb.size());
    return hasher.finish();
}

Sha256 state_hash(const Model& model) {
    Sha256Stream hasher;
    hasher.add(model.name().data(), model.name().size());
    hasher.add_little_endian(static_cast<std::uint64_t>(model.steps_done()));
    for (const StateField& field : model.state()) add_doubles(hasher, field.values);
    return hasher.finish();
}

Sha256 text_hash(std::string_view text) {
    Sha256Stream hasher;
    hasher.add(text.data(), text.size());
    return hasher.finish();
}

Sha256 file_hash(const std::filesystem::path& file) {
    return text_hash(read_input_file(file));
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
