#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// The mean of a field over y, for each x: what runs straight down a slope toward −y. Cells without
/// data do not count; NaN where a column has no other.
std::vector<double> downslope_mean(const Grid& field, const Mask& nodata);

}  // namespace fumon
