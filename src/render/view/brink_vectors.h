#pragma once

#include <cstdint>
#include <vector>

/// The loop over the cells of a fine row that refined_with_brinks() corrects, see vectors/target.h:
/// the same bits on every target.
namespace fumon::brink_vectors {

/// What edges change of heights, on fine cells, x fastest: the bits of a cell's value, and over
/// them those of the next one's, so that both are looked up at once.
struct Changes {
    const std::uint64_t* pairs;
    int nx;
    int ny;
};

/// The pairs of `count` values.
std::vector<std::uint64_t> pairs_of(const float* values, int count);

/// The edges about the cells of a row: where there is one (not 0), and a unit vector along it.
struct RowOfEdges {
    const float* share;
    const float* east;
    const float* north;
};

/// Places looked at to either side of a cell.
constexpr int places_aside = 6;

/// Adds to the heights of row `y` the means of the changes along the edges about its cells, of
/// places `step` cells apart, the farther the less; where there is no edge nothing.
void add_means_along(const Changes& changes, int y, const RowOfEdges& edges, float step,
                     float* heights);

}  // namespace fumon::brink_vectors
