#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// The mean of a field over the rows from `first` to `last` where it is known, column by column;
/// NaN where it is nowhere. `unknown`: 1 in cells without a value; empty: there are none.
std::vector<double> row_means(const Grid& field, const Mask& unknown, int first, int last);

}  // namespace fumon
