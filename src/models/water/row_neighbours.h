#pragma once

#include <vector>

#include "models/water/kernels/sediment_vectors.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// What stands in for a neighbour outside the domain: beyond an edge that is not periodic, or
/// without data.
enum class GhostValue {
    extrapolated,  ///< as far as the line through the cell and its other neighbour goes
    same,          ///< the cell's own value
    opposite,      ///< its negative, so that nothing passes between them
};

/// The four neighbours of the cells of a row, as arrays.
class RowNeighbours {
  public:
    explicit RowNeighbours(int nx)
        : cells_(static_cast<std::size_t>(nx) + 2),
          west_(static_cast<std::size_t>(nx)),
          east_(west_),
          south_(west_),
          north_(west_) {}

    /// Of row y; they live until the next call. `beyond_x` and `beyond_y` hold at the domain's
    /// edges; beside cells without data it is `beyond_hole`.
    sediment::Sides of(const Grid& field, const WaterDomain& domain, int y, GhostValue beyond_x,
                       GhostValue beyond_y, GhostValue beyond_hole);

  private:
    const double* ghost_row(const Grid& field, int y, int by, GhostValue rule,
                            std::vector<double>& scratch);
    void fill_holes(const Grid& field, const WaterDomain& domain, int y, GhostValue rule,
                    const sediment::Sides& plain);

    std::vector<double> cells_;  ///< the row, with a cell past either end
    std::vector<double> west_, east_, south_, north_;
};

}  // namespace fumon
