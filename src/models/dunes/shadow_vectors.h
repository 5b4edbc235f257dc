#pragma once

#include <cstdint>

/// The steps of wind shadows as loops over vectors of lines.
namespace fumon::shadow_vectors {

/// The surfaces that fall downwind along lines side by side.
struct Lines {
    double* soft;   ///< m, falling at the soft angle
    double* full;   ///< m, falling at the full angle
    double* since;  ///< m, how far upwind the soft surface begins
    int count;
};

/// Where the lines stand between the cells of a row: line i is at cell i + beyond.
struct Between {
    const double* heights;  ///< m, of count + 1 cells
    double beyond;          ///< 0 … 1
};

/// A cell's way along the lines: its length and how far the surfaces fall on it, metres.
struct Fall {
    double length;
    double soft;
    double full;
};

/// Lets the surfaces fall.
void fall(const Lines& lines, const Fall& fall);

/// What the surfaces do to the cells 1 … count − 1, which lie between two lines: shade 0 … 1, and
/// the higher of ground and full surface, m. `range` is the difference of the angles' tangents.
void shade(const Lines& lines, const Between& between, double range, double* shade,
           double* envelope);

/// Lifts the surfaces to the ground below the lines.
void lift(const Lines& lines, const Between& between);

/// The lowest and the highest of a row of at least one height.
void range_of_row(const std::int64_t* heights, int count, std::int64_t& lowest,
                  std::int64_t& highest);

}  // namespace fumon::shadow_vectors
