#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "files/sha256.h"
#include "models/model.h"
#include "render/image.h"

namespace fumon {

/// SHA-256 over width and height (32-bit little-endian) and RGB8 rows, top row first.
Sha256 pixel_hash(const Image& image);

/// SHA-256 over model name, step (64-bit little-endian) and every state field in declared order
/// (float64 little-endian).
Sha256 state_hash(const Model& model);

/// SHA-256 of a text's bytes.
Sha256 text_hash(std::string_view text);

/// SHA-256 of a file's bytes. Throws InputError when it cannot be read.
Sha256 file_hash(const std::filesystem::path& file);

std::string hex(const Sha256& hash);

}  // namespace fumon
