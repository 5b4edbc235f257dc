#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

/// A picture laid over a bed: its pixels cover the bed's extent, of equal size.
struct Drape {
    int width = 0;   ///< pixels eastward
    int height = 0;  ///< and northward
    /// Red, green, blue (sRGB) and opacity of each, 0 … 255, the southernmost row first; colours
    /// are not multiplied by the opacity. Opacity 0: the ground shows.
    std::vector<std::uint8_t> texels;
    bool strength_counts = true;  ///< look.drape_strength; false: it is in the opacity already
};

}  // namespace fumon
