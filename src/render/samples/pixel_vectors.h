#pragma once

#include <cstddef>
#include <cstdint>

namespace fumon::pixel_vectors {

// How a pixel of endless ground is coloured. As a whole, where all its samples see the same ground:
// near ground for which one look at the bed's maps does, level or steep; other near ground; far
// ground. Of other pixels which samples there are: the sum of these.
constexpr std::uint32_t near_samples = 1;
constexpr std::uint32_t far_samples = 2;
constexpr std::uint32_t first_whole = 4;
constexpr std::uint32_t level = 4;
constexpr std::uint32_t steep = 5;
constexpr std::uint32_t near = 6;
constexpr std::uint32_t far = 7;

/// What tells whole pixels apart. Lengths are the block's.
struct Bounds {
    float near_to;     ///< no ripple is seen beyond
    float level_fall;  ///< the steepest that level ground is
    float texels;      ///< of the bed's maps to a length
    float extent_x;    ///< of the bed
    float extent_y;
    bool varied;  ///< far copies are unlike it, see FarCopies
    float east;   ///< the eye's place from the middle of what is as it is, periods
    float north;
};

/// Rays of a row of samples: through the first one, and how they change rightward.
struct Rays {
    float first[3];
    float right[3];
};

/// Samples in the corners of a row of pixels, as seen_vectors::lengths_of_row() leaves them, from
/// the first pixel's on; and the rays of both rows from the picture's first column.
struct Corners {
    const std::uint32_t* lower;
    const std::uint32_t* upper;
    Rays lower_rays;
    Rays upper_rays;
    float first_column;
    int factor;  ///< samples along each side of a pixel, 2 or more
};

/// How each of `count` pixels is coloured, as far as its corners tell.
void kinds_of_row(const Corners& corners, const Bounds& bounds, std::size_t count,
                  std::uint32_t* kinds);

}  // namespace fumon::pixel_vectors
