#pragma once

#include <cstdint>
#include <vector>

#include "base/huge_pages.h"

/// The loop over the cells of a fine row that refined_with_brinks() corrects, see vectors/target.h:
/// the same bits on every target.
namespace fumon::brink_vectors {

/// Heights of fine cells, x fastest: the bits of a cell's, and over them those of the next one's,
/// so that both are looked up at once.
struct Heights {
    const std::uint64_t* pairs;
    int nx;
    int ny;
};

/// The pairs of `count` values.
std::vector<std::uint64_t, HugePageAllocator<std::uint64_t>> pairs_of(const float* values,
                                                                      int count);

/// The edges about the cells of a row: how much of one there is (0 … 1), and a vector along it,
/// in whose lengths points are apart.
struct RowOfEdges {
    const float* share;
    const float* east;
    const float* north;
};

/// Points looked at to either side of a cell.
constexpr int positions_aside = 4;

/// Mixes into the heights of row `y`, as far as there are edges, the means along the edges about
/// its cells, of points `step` cells apart, the farther the less.
void mix_means_along(const Heights& field, int y, const RowOfEdges& edges, float step,
                     float* heights);

}  // namespace fumon::brink_vectors
