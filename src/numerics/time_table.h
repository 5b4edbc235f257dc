#pragma once

#include <span>

namespace fumon {

/// The value at a time of a table that is linear between its times (rising, at least one) and
/// constant before and after them.
double value_at(std::span<const double> times, std::span<const double> values, double time);

/// The mean from `from` to `to` (> from) of a staircase: each value holds from its time to the
/// next one, the last for ever; 0 before the first.
double mean_of_steps(std::span<const double> times, std::span<const double> values, double from,
                     double to);

}  // namespace fumon
