#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

/// An RGB picture, 8 bits a channel, top row first; with opacities, where something can be seen
/// through it. A plain value.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< 3·width·height bytes
    /// width·height opacities, 0 … 255, by which colours are not multiplied; empty: all opaque.
    std::vector<std::uint8_t> alpha;

    Image() = default;
    Image(int width_, int height_)
        : width(width_),
          height(height_),
          rgb(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

    [[nodiscard]] const std::uint8_t* row(int y) const {
        return rgb.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    std::uint8_t* row(int y) {
        return rgb.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }

    [[nodiscard]] bool transparent() const { return !alpha.empty(); }

    friend bool operator==(const Image&, const Image&) = default;
};

/// An image without opacities: laid on an even grey ground, in sRGB as programs do it.
Image laid_on(const Image& image, std::uint8_t grey);
/// An image with opacities, of 255 where it has none.
Image with_alpha(Image image);

}  // namespace fumon
