#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "picture/png.h"

namespace fumon {

/// The longest side of a WebP picture, pixels.
inline constexpr int longest_webp_side = 16383;

/// The WebP file of an image, with its opacities: without loss, or of a quality of 1 … 100, the
/// scale of libwebp. Dots per inch and sRGB stand in Exif, the texts in XMP. The same input gives
/// the same bytes. Throws InputError for an image larger than `longest_webp_side`.
std::vector<std::uint8_t> encode_webp(const Image& image, bool lossless, int quality,
                                      double dots_per_inch, const PictureText& texts);

/// Whether bytes start as a WebP file's do.
bool is_webp(std::string_view bytes);

/// The texts of a WebP file's XMP. Throws InputError where it is damaged or truncated; `name` is
/// the file's.
PictureText webp_texts(std::string_view bytes, const std::string& name);

/// The pixels of a WebP file that stands still, with opacities where it stores some. Throws
/// InputError where it moves, is damaged or truncated.
Image decode_webp(std::string_view bytes, const std::string& name);

}  // namespace fumon
