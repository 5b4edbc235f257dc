#include "files/hash.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

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

namespace {

namespace fs = std::filesystem;

/// The files below a folder, by their names within it.
std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder));
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace

bool is_zarr(const fs::path& path) {
    std::error_code fault;
    return path.extension() == ".zarr" && fs::is_directory(path, fault);
}

Sha256 file_hash(const fs::path& file) {
    Sha256Stream hasher;
    if (is_zarr(file)) {
        for (const std::string& name : files_below(file)) {
            const std::string line = name + '\n' + hex(file_hash(file / name)) + '\n';
            hasher.add(line.data(), line.size());
        }
        return hasher.finish();
    }
    stream_input_file(file, std::numeric_limits<std::int64_t>::max(),
                      [&](std::string_view bytes) { hasher.add(bytes.data(), bytes.size()); });
    return hasher.finish();
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
