#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

/// An RGB picture, 8 bits a channel, top row first. A plain value.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< 3·width·height bytes

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

    friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace fumon
