#pragma once

/// The steps of wind shadows as loops over vectors of lines.
namespace fumon::shadow_vectors {

/// The surfaces that fall downwind along lines side by side.
struct Lines {
    double* soft;  ///< m, falling at the soft angle
    double* full;  ///< m, falling at the full angle
    int count;
};

/// Where the lines stand between the cells of a row: line i is at cell i + beyond.
struct Between {
    const double* heights;  ///< m, of count + 1 cells
    double beyond;          ///< 0 … 1
};

/// Lets the surfaces fall by so many metres.
void fall(const Lines& lines, double soft_drop, double full_drop);

/// What the surfaces do to the cells 1 … count − 1, which lie between two lines: shade 0 … 1, and
/// the higher of ground and full surface, m.
void shade(const Lines& lines, const Between& between, double* shade, double* envelope);

/// Lifts the surfaces to the ground below the lines.
void lift(const Lines& lines, const Between& between);

}  // namespace fumon::shadow_vectors
