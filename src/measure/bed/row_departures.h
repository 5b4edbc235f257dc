#pragma once

#include <span>

#include "base/grid.h"

namespace fumon {

/// The departures of a row from its mean or, if the bed is not periodic, from its least-squares
/// line, since a slope from end to end is not a wave. Exactly zero in a row whose departures are
/// rounding only (below 1e-12 of its largest height). `departures` takes the row's nx values.
void row_departures(std::span<const double> row, bool periodic, std::span<double> departures);

}  // namespace fumon
