#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/grid.h"

namespace fumon {

/// The departures of a row from its mean or, if the bed is not periodic, from its least-squares
/// line, since a slope from end to end is not a wave. Exactly zero in a row whose departures are
/// rounding only (below 1e-12 of its largest height). `departures` takes the row's nx values.
void detrend_row(std::span<const double> row, bool periodic, std::span<double> departures);
/// The same of a row whose mean is known.
void detrend_row(std::span<const double> row, double mean, bool periodic,
                 std::span<double> departures);

/// The means of `count` rows from `first` on, at most eight, each summed from its first site on:
/// side by side, since a sum waits for each of its additions.
constexpr std::size_t most_row_means = 8;
std::array<double, most_row_means> row_means(const Grid& bed, int first, int count);

}  // namespace fumon
