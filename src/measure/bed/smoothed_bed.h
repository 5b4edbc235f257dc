#pragma once

#include "base/grid.h"

namespace fumon {

/// A bed smoothed by a triangular kernel in x and y: twice the mean of 2·radius + 1 sites each way.
/// Past the edges of a bed that is not periodic its outermost cells go on. The radius is cut to
/// what fits into the bed; 0 leaves it as it is.
Grid smoothed_bed(const Grid& bed, bool periodic, int radius);

}  // namespace fumon
