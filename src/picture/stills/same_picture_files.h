#pragma once

#include <filesystem>

namespace fumon {

/// Whether two files hold the same bytes, and these are a whole PNG, JPEG or WebP file, as far as
/// that can be told without decoding it: a PNG's checksums, a JPEG's last mark, a WebP's length.
/// False also where one of them cannot be read.
bool same_picture_files(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace fumon
