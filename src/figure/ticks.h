#pragma once

#include <string>
#include <vector>

namespace fumon {

/// The marks of an axis or colour bar: round values within its range, and what stands beside them.
struct Ticks {
    std::vector<double> values;
    std::vector<std::string> labels;  ///< as many, with a true minus sign
};

/// Marks at multiples of 1, 2 or 5 times a power of ten within [low, high]: the finest such step
/// that needs no more than `most` of them (at least 2). None for a range that is empty or not
/// finite.
Ticks linear_ticks(double low, double high, int most);

/// Marks at the whole powers of ten within [low, high], every n-th where they are more than `most`.
/// None unless 0 < low < high.
Ticks logarithmic_ticks(double low, double high, int most);

}  // namespace fumon
