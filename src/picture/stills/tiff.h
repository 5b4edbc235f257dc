#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "picture/png.h"

namespace fumon {

/// The TIFF file of an image of 8 bits a channel: LZW with differences of neighbours, its dots per
/// inch, an ICC profile and the texts as XMP (tag 700). RGB with sRGB's profile, and the opacities
/// as a fourth channel where there are any; with the bytes of a profile of a printer's inks, CMYK
/// of that profile, what is seen through laid on white. The same input gives the same bytes.
/// Throws InputError for an image of no pixels or more than 2^30 bytes, and as cmyk_of().
std::vector<std::uint8_t> encode_tiff(const Image& image, double dots_per_inch,
                                      const PictureText& texts,
                                      const std::string& cmyk_profile = {});

/// Whether bytes start as a TIFF file's do.
bool is_tiff(std::string_view bytes);

/// The texts of a TIFF file's XMP; none of a file without. Throws InputError where it is damaged;
/// `name` is the file's.
PictureText tiff_texts(std::string_view bytes, const std::string& name);

/// The pixels of a TIFF file's first picture as RGB of 8 bits, with opacities where it stores some.
/// Throws InputError where it is damaged, too large or has colours for print.
Image decode_tiff(std::string_view bytes, const std::string& name);

}  // namespace fumon
