#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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
    /// The colours at 16 bits a channel, of which `rgb` is the rounding; empty: there are none.
    std::vector<std::uint16_t> rgb16;

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

/// A level of 16 bits to the nearest of 8, as libpng rounds it.
constexpr std::uint8_t rounded_to_8(std::uint16_t level) {
    return static_cast<std::uint8_t>((level * 255U + 32895U) >> 16U);
}

/// One number a pixel, top row first.
struct ImageLayer {
    std::string name;  ///< a channel, as OpenEXR names them: "R", "normal.X"
    std::string unit;
    bool half = false;  ///< whether 16 bits are enough for it
    std::vector<float> values;
};

/// A picture of many numbers a pixel.
struct LayeredImage {
    int width = 0;
    int height = 0;
    std::vector<ImageLayer> layers;
    /// From the world in the layers' lengths to the camera's coordinates (right, up, ahead), and to
    /// the picture's, 0 … 1 from its upper left corner; for points as rows.
    std::array<float, 16> world_to_camera{};
    std::array<float, 16> world_to_picture{};
};

/// An image without opacities: laid on an even grey ground, in sRGB as programs do it.
Image composited_on(const Image& image, std::uint8_t grey);
/// An image with opacities, of 255 where it has none.
Image with_alpha(Image image);

}  // namespace fumon
