#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/image.h"
#include "base/sha256.h"

namespace fumon {

/// SHA-256 over width and height (32-bit little-endian) and RGB8 rows, top row first.
Sha256 pixel_hash(const Image& image);

/// SHA-256 of a text's bytes.
Sha256 text_hash(std::string_view text);

/// SHA-256 of a file's bytes. Throws InputError when it cannot be read.
Sha256 file_hash(const std::filesystem::path& file);

std::string hex(const Sha256& hash);

}  // namespace fumon
