#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"

namespace fumon {

/// A rectangle of a picture's pixels, from its upper left corner.
struct PixelBox {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t width = 0;
    std::int64_t height = 0;
};

/// Pixels of a picture that a comparison leaves out.
struct IgnoredPixels {
    int width = 0;   ///< of the picture
    int height = 0;  ///< of the picture
    /// width·height flags, top row first: 1 where a pixel is ignored; empty where none is.
    std::vector<std::uint8_t> flags;

    /// None yet of a picture of that size.
    IgnoredPixels(int width_, int height_) : width(width_), height(height_) {}
    IgnoredPixels() = default;

    [[nodiscard]] bool any() const { return !flags.empty(); }
    [[nodiscard]] std::int64_t count() const;
    [[nodiscard]] double share() const;  ///< of the picture's pixels, 0 … 1
    /// The flags of a row, where any pixel is ignored.
    [[nodiscard]] const std::uint8_t* row(int y) const {
        return flags.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    /// SHA-256 of size and flags, hexadecimal; empty where none is ignored.
    [[nodiscard]] std::string hash() const;

    /// Adds what of a box lies in the picture.
    void add(const PixelBox& box);
    /// Adds the pixels of a mask of the picture's size that are white: of luminance 128 and more.
    void add(const Image& mask);

  private:
    void make_flags();
};

/// The largest share of a picture that may be ignored.
inline constexpr double largest_ignored_share = 0.3;

/// The picture as it is compared and recorded: ignored pixels of one grey, opaque.
Image blanked(const Image& image, const IgnoredPixels& ignored);

/// The picture with ignored pixels hatched: stripes that rise to the right, over what is there.
Image hatched(const Image& image, const IgnoredPixels& ignored);

}  // namespace fumon
