#pragma once

#include <cstddef>
#include <cstdint>

/// Loops over rows of levels of 8 bits, three a pixel, and over tiles of their luminances, compiled
/// for vectors (see vectors/target.h). All is reckoned in whole numbers.
namespace fumon::level_vectors {

/// What the levels of two rows differ by.
struct RowDifference {
    int largest = 0;  ///< 0 … 255
    int changed = 0;  ///< pixels of which a level differs
    std::int64_t sum = 0;
};

RowDifference row_difference(const std::uint8_t* first, const std::uint8_t* second, int pixels);

/// Where two rows of pixels differ, as difference_picture() shows it.
void mark_row(const std::uint8_t* first, const std::uint8_t* second, int pixels, std::uint8_t* out);

/// 256 times the luminance 0.299 R + 0.587 G + 0.114 B, from 0 to 65280, less this middle.
inline constexpr std::int32_t middle_luminance = 32640;

void luminance_row(const std::uint8_t* levels, int pixels, std::int16_t* out);

/// Sums over one tile's pixels of two luminances a and b, each less the middle.
struct TileSums {
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t aa = 0;
    std::int64_t bb = 0;
    std::int64_t ab = 0;
};

inline constexpr int tile_side = 8;  ///< pixels

/// The sums of `tiles` tiles side by side, of 8 columns and `rows` rows, at most 8: the first
/// begins at `a` and `b`, and `stride` luminances lie from row to row.
void tile_sums(const std::int16_t* a, const std::int16_t* b, std::size_t stride, int rows,
               int tiles, TileSums* out);

}  // namespace fumon::level_vectors
