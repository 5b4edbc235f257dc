#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/image.h"
#include "base/sha256.h"
#include "render/colour/colouring.h"

namespace fumon {

/// The picture of a run before anything is written on it, and the colours that a colour bar over it
/// shows.
struct CachedPicture {
    Image image;
    FrameColourRange colours;
};

/// A file of the picture, which names its key: each pixel less the one before it, compressed by
/// libdeflate at its level 1. Throws Error where memory is short.
std::vector<std::uint8_t> encode_cached_picture(const CachedPicture& picture, const Sha256& key);

/// The picture of such a file; nothing where it is damaged, cut short or of another key.
std::optional<CachedPicture> decode_cached_picture(std::span<const std::uint8_t> file,
                                                   const Sha256& key);

}  // namespace fumon
