#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "base/sha256.h"
#include "picture/png.h"

namespace fumon {

/// The OpenEXR file of a picture: scan lines in ZIP compression, a channel a layer (16 or 32 bits,
/// as its `half` says), primaries of Rec. 709, the texts as attributes of strings, and
/// "fumon:units" with a line "CHANNEL: UNIT" each. The same input gives the same bytes. Throws
/// Error where a text or a channel cannot stand in such a file.
std::vector<std::uint8_t> encode_exr(const LayeredImage& image, double dots_per_inch,
                                     const PictureText& texts);

/// Whether a file begins as OpenEXR's do.
bool is_exr(std::string_view head);

/// The texts of an OpenEXR file. Throws InputError where it is damaged.
PictureText read_exr_texts(const std::filesystem::path& file);

/// SHA-256 over width and height (32-bit little-endian) and, layer by layer, its name and its
/// values as they are stored (IEEE 754 numbers of 16 or 32 bits, little-endian), top row first.
Sha256 layers_hash(const LayeredImage& image);

}  // namespace fumon
