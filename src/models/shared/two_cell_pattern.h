#pragma once

#include <cstddef>

#include "base/grid.h"

namespace fumon {

/// Where a bed has changed by turns from cell to cell, which no grid resolves.
struct TwoCellPattern {
    double share = 0.0;    ///< of the cells that have changed
    std::size_t cell = 0;  ///< of that pattern, where it is deepest
};

/// The cells of stretches, along a row or a column, in which the change of a bed goes up and down
/// by turns over six cells or more. Up and down is what a filter of five cells lets pass (fourth
/// differences / 16, which is 1 for two cells and a quarter for four), if it is more than 0.15 of
/// the change around it. Cells count as changed from 0.3 of the mean change on. `change`: of the
/// bed since its start, in any unit.
TwoCellPattern two_cell_pattern(const Grid& change);

}  // namespace fumon
