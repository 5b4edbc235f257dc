#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "picture/png.h"

namespace fumon {

/// The longest side of a JPEG picture, pixels.
inline constexpr int longest_jpeg_side = 65500;

/// The JPEG file of an image (ITU-T T.81, progressive, all colours at full resolution); what can be
/// seen through stands on white. Its size in inches stands in JFIF and Exif, sRGB in Exif, the
/// texts in XMP. `quality`: 1 … 100, the scale of libjpeg. The same input gives the same bytes.
/// Throws InputError for an image larger than `longest_jpeg_side`.
std::vector<std::uint8_t> encode_jpeg(const Image& image, int quality, double dots_per_inch,
                                      const PictureText& texts);

/// Whether bytes start as a JPEG file's do.
bool is_jpeg(std::string_view bytes);

/// The texts of a JPEG file's XMP. Throws InputError where it is damaged or truncated; `name` is
/// the file's.
PictureText jpeg_texts(std::string_view bytes, const std::string& name);

/// The pixels of a JPEG file, of grey levels too. Throws InputError where it is damaged or
/// truncated, holds colours for print (CMYK), or has more than 2^28 pixels.
Image decode_jpeg(std::string_view bytes, const std::string& name);

}  // namespace fumon
