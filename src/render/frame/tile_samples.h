#pragma once

#include <glm/glm.hpp>

namespace fumon {

/// Where a tile lies in the picture, in samples from the lower left corner.
struct TileSamples {
    glm::vec2 picture_size;
    glm::vec2 corner;
    glm::vec2 size;
};

/// Where pixels lie among a target's samples.
struct PixelSamples {
    glm::ivec2 first;  ///< the lower left pixel's lower left sample
    int factor = 1;    ///< samples along each side of a pixel
    int rows = 0;      ///< of pixels, from the lowest on, above which none sees ground
    int columns = 0;   ///< of pixels
    int all_rows = 0;  ///< of pixels
};

}  // namespace fumon
