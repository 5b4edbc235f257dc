#pragma once

#include "base/image.h"
#include "picture/pixels/ignored_pixels.h"

namespace fumon {

class WorkerPool;

/// The tile in which two pictures resemble each other least.
struct TileSimilarity {
    double smallest = 1.0;  ///< SSIM, -1 … 1; 1: every tile has the same luminance
    int x = 0;              ///< of the tile's left column, pixels
    int y = 0;              ///< of its top row
};

/// Smallest structural similarity of two pictures of one size over tiles of 8 × 8 pixels side by
/// side; where a side is no multiple of 8 the last tiles reach back over their neighbours, and a
/// picture smaller than a tile is one tile. SSIM of Wang, Bovik, Sheikh & Simoncelli 2004, eq.
/// (13),
///
///     (2 μ₁ μ₂ + C₁)(2 σ₁₂ + C₂) / ((μ₁² + μ₂² + C₁)(σ₁² + σ₂² + C₂)),
///     C₁ = (0.01 · 255)², C₂ = (0.03 · 255)²,
///
/// with means, and variances over n - 1, of a tile's luminance 0.299 R + 0.587 G + 0.114 B (ITU-R
/// BT.601) in 256ths of a grey level. The constants keep flat tiles from dividing by zero. Ignored
/// pixels are none of a tile's; the result is the same on any number of threads.
TileSimilarity tile_similarity(const Image& first, const Image& second,
                               const IgnoredPixels& ignored, WorkerPool& pool);
TileSimilarity tile_similarity(const Image& first, const Image& second);

}  // namespace fumon
