#pragma once

#include <cstddef>
#include <cstdint>

#include "base/image.h"

namespace fumon::test {

/// A picture with gradients and edges in all channels.
inline Image some_picture(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
            pixel[0] = static_cast<std::uint8_t>((200 * x) / width + 20);
            pixel[1] = static_cast<std::uint8_t>((x / 5 + y / 3) % 2 == 0 ? 60 : 180);
            pixel[2] = static_cast<std::uint8_t>((150 * y) / height + ((7 * x + 13 * y) % 40));
        }
    }
    return image;
}

inline Image flat_picture(int width, int height, std::uint8_t level) {
    Image image(width, height);
    for (std::uint8_t& value : image.rgb) value = level;
    return image;
}

}  // namespace fumon::test
