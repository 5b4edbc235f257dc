#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "picture/png.h"

namespace fumon {

/// The formats of pictures of three or four channels of 8 bits a pixel; PNG may have 16.
enum class PictureFormat { png, jpeg, webp, tiff };

/// What JPEG and WebP are asked for; PNG and TIFF lose nothing.
struct PictureCoding {
    int quality = 92;       ///< 1 … 100
    bool lossless = false;  ///< WebP; JPEG cannot
};

/// By the ending of a file's name, in small letters or capitals: .jpg and .jpeg, .webp, .tif and
/// .tiff; PNG for any other.
PictureFormat picture_format(const std::filesystem::path& file);
/// "PNG", "JPEG", "WebP", "TIFF".
std::string_view name_of(PictureFormat format);

/// The file of an image in a format, with its texts. Throws as encode_png(), encode_jpeg(),
/// encode_webp() and encode_tiff(), and InputError where the format cannot hold it: 16 bits a
/// channel in all but PNG, no loss in JPEG.
std::vector<std::uint8_t> encode_picture(const Image& image, PictureFormat format,
                                         const PictureCoding& coding, double dots_per_inch,
                                         const PictureText& texts);

/// Whether a file begins as a PNG, JPEG, WebP or TIFF file does; 12 bytes are enough.
bool is_picture(std::string_view head);

/// The texts of such a file. Throws InputError where it is none of them or is damaged.
PictureText read_picture_texts(const std::filesystem::path& file);

/// Its pixels, as read_png() gives them. Throws InputError likewise.
Image read_picture(const std::filesystem::path& file);

}  // namespace fumon
