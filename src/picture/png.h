#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"

namespace fumon {

/// Keyword → UTF-8 text, written as iTXt in this order.
using PictureText = std::vector<std::pair<std::string, std::string>>;

/// The text of a picture that says no more than that it is fumon's. It is the same in every
/// version.
inline PictureText own_text() {
    return {{"Software", "fumon"}};
}

/// Of pictures that are for looking at on a screen.
inline constexpr double screen_dots_per_inch = 96.0;

/// The PNG file of an image, of 16 bits a channel where it has them: filter "sub", compressed by
/// libdeflate at its level 1, which takes half of zlib's time and less space; the chunks are
/// libpng's. The physical size stands in pHYs, the texts in iTXt. The same input gives the same
/// bytes.
std::vector<std::uint8_t> encode_png(const Image& image, double dots_per_inch,
                                     const PictureText& texts);

/// The iTXt, tEXt and zTXt texts of a PNG file. Throws InputError when it is not a PNG or is
/// damaged.
PictureText read_png_texts(const std::filesystem::path& file);

/// The pixels of a PNG file as RGB, 8 bits a channel, with opacities where the file stores some; 16
/// bits are rounded to 8. Throws InputError when it is not a PNG or is damaged.
Image read_png(const std::filesystem::path& file);

}  // namespace fumon
