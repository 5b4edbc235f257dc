#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"

namespace fumon {

/// The inks of an image's sRGB pixels by an ICC profile of a printer: cyan, magenta, yellow and
/// black, 0 (none) … 255, row by row; by Little CMS, relative to the paper, with black kept black
/// (black point compensation). Throws InputError where the bytes are no profile of four inks.
std::vector<std::uint8_t> cmyk_of(const Image& image, const std::string& profile);

/// Throws InputError where the bytes are no ICC profile of the inks CMYK for output.
void check_cmyk_profile(const std::string& profile);

}  // namespace fumon
