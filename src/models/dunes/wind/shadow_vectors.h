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

/// Goes on to the next row: lets the surfaces fall, finds what they do to its cells 1 … count − 1,
/// which lie between two lines, and lifts them to the ground below the lines. `shade`: 0 … 1, may
/// be `heights`; `envelope`: the higher of ground and full surface, m; each may be null. `range` is
/// the difference of the angles' tangents. All rows have room for a whole number of vectors.
void advance_lines(const Lines& lines, const Fall& fall, const Between& between, double range,
                   double* shade, double* envelope);

/// Heights from −2⁵¹ to 2⁵¹ units in metres.
void to_metres(const std::int64_t* units, int count, double* metres);

/// The lowest and the highest of a row of at least one height.
void range_of_row(const std::int64_t* heights, int count, std::int64_t& lowest,
                  std::int64_t& highest);

}  // namespace fumon::shadow_vectors
