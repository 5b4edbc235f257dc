#pragma once

#include <cstdint>
#include <string>

namespace fumon {

/// "8MB", "500kB", "1.5GB" or bytes as a number of bytes. Throws InputError for another text, which
/// names what the size is of.
std::int64_t bytes_of_size(const std::string& text, const std::string& name = "--max-size");

}  // namespace fumon
