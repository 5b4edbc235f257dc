#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// A point over a grid in cells: 0 … nx eastward and 0 … ny northward, cell (0, 0) being the square
/// from (0, 0) to (1, 1).
struct OutlinePoint {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const OutlinePoint&, const OutlinePoint&) = default;
};

/// A closed line, whose last point is joined to its first; cells with data lie on its left.
using OutlineLoop = std::vector<OutlinePoint>;

/// The outline of the cells that have data (mask 0), drawn between cells: the steps along their
/// edges are pulled straight as far as each of their corners may move by half a cell along x and
/// y. Where the mask holds the cells whose centres lie within a straight edge, that edge comes out
/// straight. Along the border of the grid it stays where it is, and so do corners where two parts
/// touch; parts and holes of a few cells are rounded alone. Independent of anything but the mask.
std::vector<OutlineLoop> mask_outline(const Mask& nodata);

/// The cells, `refinement` times finer, whose centres lie outside the outline of a grid of nx × ny.
Mask outside_of(const std::vector<OutlineLoop>& outline, int nx, int ny, int refinement);

/// The nearest points on an outline.
class OutlineSearch {
  public:
    /// Keeps a reference to the outline.
    OutlineSearch(const std::vector<OutlineLoop>& outline, int nx, int ny);

    /// The point of the outline that is nearest to another one, and that one itself where none is
    /// within `reach` cells.
    [[nodiscard]] OutlinePoint nearest(OutlinePoint to, double reach) const;

  private:
    struct Piece {
        OutlinePoint from;
        OutlinePoint to;
    };

    int nx_;
    int ny_;
    std::vector<Piece> pieces_;       // of one cell after the other
    std::vector<std::size_t> first_;  // of each cell, and the end
};

}  // namespace fumon
