#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/image.h"
#include "picture/fingerprint.h"
#include "picture/pixels/ignored_pixels.h"
#include "picture/tile_similarity.h"

namespace fumon {

/// How far two pictures of the same size are apart. A pixel counts as changed if any of its three
/// levels differs. Shares and means are of the pixels that are not ignored; in thumbnails ignored
/// ones are grey.
struct Comparison {
    int largest = 0;           ///< difference of a level, 0 … 255
    std::int64_t changed = 0;  ///< pixels
    double changed_share = 0.0;
    double mean = 0.0;  ///< difference of a level, over all levels of all pixels
    TileSimilarity tiles;
    ThumbnailDifference thumbnail;  ///< of thumbnails that are not rounded
    std::int64_t ignored = 0;       ///< pixels
    double ignored_share = 0.0;     ///< of all pixels
};

/// Compares two pictures of one size. Throws InputError where their sizes differ or they are empty.
/// Large ones take all processors; the numbers are the same on any.
Comparison compare(const Image& first, const Image& second, const IgnoredPixels& ignored = {});

/// How alike two pictures are, from the least to the most.
enum class Likeness { different, close, same_to_the_eye, identical };

/// "different", "close", "same to the eye", "identical".
std::string_view name_of(Likeness likeness);

/// How much two pictures may differ at a level; both limits must hold. assets/guide/verify.md lists
/// what each lets through, as measured.
struct LikenessLimits {
    double thumbnail;  ///< grey levels, at most
    double tile_ssim;  ///< of the least similar tile, at least
};

inline constexpr LikenessLimits same_to_the_eye_limits{0.5, 0.95};
inline constexpr LikenessLimits close_limits{3.0, 0.4};

Likeness likeness(const Comparison& comparison);

/// The levels and what each lets through, a line each.
std::string likeness_help();

/// Where two pictures of one size differ: the first in dim grey, changed pixels over it from dark
/// red for a level to bright yellow, ignored ones hatched.
Image difference_picture(const Image& first, const Image& second,
                         const IgnoredPixels& ignored = {});

}  // namespace fumon
