#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/image.h"
#include "base/sha256.h"

namespace fumon {

/// SHA-256 over width and height (32-bit little-endian) and RGB8 rows, top row first.
Sha256 pixel_hash(const Image& image);

/// SHA-256 of a text's bytes.
Sha256 text_hash(std::string_view text);
/// SHA-256 of bytes.
Sha256 bytes_hash(std::span<const std::uint8_t> bytes);

/// Whether a path leads to a folder that is one Zarr store, by its ending.
bool is_zarr(const std::filesystem::path& path);

/// SHA-256 of a file's bytes, however many; of a Zarr store that of its files' names and hashes,
/// sorted by name. Throws as read_input_file otherwise.
Sha256 file_hash(const std::filesystem::path& file);

std::string hex(const Sha256& hash);

}  // namespace fumon
