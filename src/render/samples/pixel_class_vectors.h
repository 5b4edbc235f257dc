#pragma once

#include <cstddef>
#include <cstdint>

namespace fumon::pixel_class_vectors {

// How a pixel of endless ground is coloured. As a whole, where all its samples see the same ground:
// near ground for which one look at the bed's maps does, without tongues of avalanches or with
// them; other near ground; far ground. Of other pixels which samples there are: the sum of these.
constexpr std::uint32_t near_samples = 1;
constexpr std::uint32_t far_samples = 2;
constexpr std::uint32_t first_single_surface = 4;
constexpr std::uint32_t smooth = 4;
constexpr std::uint32_t slid = 5;
constexpr std::uint32_t near = 6;
constexpr std::uint32_t far = 7;

/// Where tongues may be, of AvalancheCells; without words everywhere. Bounds::extent_x and extent_y
/// are what the maps cover, or half of it where the bed ends in a plain.
struct AvalancheMap {
    const std::uint32_t* words = nullptr;
    int words_per_row = 0;
    int nx = 0;
    int ny = 0;
    bool plain = false;  ///< see GroundTiles
    float east = 0.0F;   ///< the eye's position from the middle of the bed
    float north = 0.0F;
};

/// Bounds that classify single-surface pixels. Lengths are the block's.
struct ClassBounds {
    float near_limit;             ///< no ripple is seen beyond
    float steepest_smooth_slope;  ///< the steepest ground without tongues, as it is drawn
    float texels;                 ///< of the bed's maps to a length
    float extent_x;               ///< of the bed
    float extent_y;
    bool varied;  ///< far copies are unlike it, see TileWarp
    float east;   ///< the eye's position from the middle of the undistorted copy, periods
    float north;
    AvalancheMap slid{};
};

/// Rays of a row of samples: through the first one, and how they change rightward.
struct Rays {
    float first[3];
    float right[3];
};

/// Samples in the corners of a row of pixels, as visibility_vectors::record_rows() leaves them; and
/// the rays of both rows from the picture's first column.
struct CornerSamples {
    const std::uint32_t* lower;  ///< of the first sample in its row
    const std::uint32_t* upper;
    std::ptrdiff_t lengths;  ///< from the number of a sample to its length
    int first;  ///< the lower left pixel's first sample in its row; even, with two samples a side,
                ///< which have a pixel's numbers together
    Rays lower_rays;
    Rays upper_rays;
    float first_column;
    int factor;  ///< samples along each side of a pixel, 2 or more
};

/// The class of each of `count` pixels for shading, from the samples in its corners.
void classify_row(const CornerSamples& corners, const ClassBounds& bounds, std::size_t count,
                  std::uint32_t* kinds);

}  // namespace fumon::pixel_class_vectors
