#pragma once

#include <span>

#include "base/grid.h"

namespace fumon {

/// What a row stands above its mean, or, where the bed is not periodic, above the straight line
/// that fits it best (least squares): a slope from end to end is no wave. Exactly zero in a row
/// whose departures are rounding only (below 1e-12 of its largest height). `departures` takes the
/// row's nx values.
void row_departures(std::span<const double> row, bool periodic, std::span<double> departures);

}  // namespace fumon
