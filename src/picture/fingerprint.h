#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "files/hash.h"

namespace fumon {

/// A picture shrunk to 32 × 18 pixels, each the mean of the picture over its box; where a box's
/// edge runs through a pixel, that counts by the area inside. A change of light, of relief or of
/// colour moves many of them by whole grey levels; another processor's rounding moves them by
/// thousandths.
struct Thumbnail {
    static constexpr int width = 32;
    static constexpr int height = 18;
    static constexpr std::size_t count = std::size_t{3} * width * height;

    /// Grey levels 0 … 255: red, green and blue of each pixel, top row first.
    std::array<double, count> levels{};

    [[nodiscard]] double at(int x, int y, int channel) const {
        return levels[index(x, y, channel)];
    }
    double& at(int x, int y, int channel) { return levels[index(x, y, channel)]; }

    friend bool operator==(const Thumbnail&, const Thumbnail&) = default;

  private:
    static std::size_t index(int x, int y, int channel) {
        const int pixel = y * width + x;
        return std::size_t{3} * static_cast<std::size_t>(pixel) + static_cast<std::size_t>(channel);
    }
};

/// A picture's fingerprint, from the strictest part to the bluntest.
struct Fingerprint {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    Sha256 pixels{};
    Thumbnail thumbnail;  ///< rounded to tenths of a grey level
    /// A label for finding pictures that look alike; it does not notice a change of light or
    /// shading.
    std::uint64_t difference_hash = 0;

    friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// The thumbnail of a picture of at least one pixel, not rounded.
Thumbnail thumbnail_of(const Image& image);

/// The same to the nearest tenth of a grey level, as fingerprints keep it.
Thumbnail in_tenths(const Thumbnail& thumbnail);

/// dHash (N. Krawetz, "Kind of Like That", 2013): the picture as 9 × 8 boxes of luminance; a bit
/// for each that is darker than its right neighbour, top row first, the first in the highest bit.
std::uint64_t difference_hash(const Image& image);

/// All three of a picture of at least one pixel.
Fingerprint fingerprint_of(const Image& image);

/// Where two thumbnails differ most.
struct ThumbnailDifference {
    double largest = 0.0;  ///< grey levels
    int x = 0;             ///< of the thumbnail's pixel, from the left
    int y = 0;             ///< and from the top
};

ThumbnailDifference thumbnail_difference(const Thumbnail& first, const Thumbnail& second);

}  // namespace fumon
