#pragma once

#include <cstdint>

/// A pass of avalanches as loops over vectors. What they leave to loops over cells, since it lies
/// at the ends of a row, they name in the words `left`. Heights are whole numbers from −2⁵¹ to 2⁵¹.
namespace fumon::slope_vectors {

/// Sets bit x of `bits` where the one-sided slope of cell x of the row `here` exceeds a limit:
///
///     (max(h − h_west, h − h_east, 0)² wx + max(h − h_south, h − h_north, 0)² wy) > limit
///
/// for 1 ≤ x < count − 1, and clears all others; `bits` has (count + 63) / 64 words.
void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits);

/// A row, the rows beside it, its floor, the lowest and the highest of each 64 cells of the floor,
/// or null, and tangents of its cells' angles of repose, or null where all have the same.
struct SlideRows {
    const std::int64_t* south;
    const std::int64_t* here;
    const std::int64_t* north;
    const std::int64_t* floor;
    const std::int64_t* lowest_floor;
    const std::int64_t* highest_floor;
    const double* tangents;
};

/// See SlopeRelaxation.
struct SlideRule {
    double slope_of_unit_x;
    double slope_of_unit_y;
    double tangent;       ///< where all cells have the same
    double start_ratio;   ///< of the tangents
    double least_square;  ///< of slopes that may slide
    double share;         ///< of the excess fall
};

/// What leaves each cell, whole numbers, positive eastward and northward, and bits of the cells
/// that it leaves.
struct Slides {
    double* x;
    double* y;
    std::uint64_t* sliding;
};

/// Finds what slides from the candidates of a row of `count` cells: 0 from those that do not slide.
/// Returns how many do.
std::int64_t slide(const SlideRows& rows, const SlideRule& rule, int count,
                   const std::uint64_t* candidates, const Slides& slides, std::uint64_t* left);

/// What slides from the cells of a row and of those beside it, 0 from those that do not slide.
struct SettledRows {
    const double* x;
    const double* y;
    const double* y_south;
    const double* y_north;
};

/// Moves what slides to and from the candidates of a row.
void settle(const SettledRows& rows, int count, const std::uint64_t* candidates,
            std::int64_t* surface, std::uint64_t* left);

}  // namespace fumon::slope_vectors
