#pragma once

namespace fumon {

/// What the numbers of a drawn pixel are.
enum class PixelFormat {
    display_8,   ///< display values (sRGB) of 8 bits a channel
    display_16,  ///< of 16 bits
    radiance     ///< linear light before exposure and tone curve, in half precision
};

}  // namespace fumon
