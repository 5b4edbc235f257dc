#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// How uneven a field is over its cells, in its own unit.
struct Unevenness {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double deviation = std::numeric_limits<double>::quiet_NaN();  ///< standard, of the population
    double range = std::numeric_limits<double>::quiet_NaN();      ///< highest less lowest
};

/// Of all cells with data; NaN without any.
Unevenness unevenness(const Grid& field, const Mask& nodata);

/// Of the field's mean down the slope (downslope_mean), each column alike; NaN where a column has
/// no data.
Unevenness downslope_unevenness(const Grid& field, const Mask& nodata);

/// The share of a field's variance about its mean that its mean down the slope explains: 1 for
/// stripes that run perfectly straight down (toward −y), about 1/ny for noise. A column counts by
/// its cells with data. NaN where the standard deviation is below 1e-9 of the mean, which is
/// rounding.
double downslope_invariant_share(const Grid& field, const Mask& nodata);

}  // namespace fumon
