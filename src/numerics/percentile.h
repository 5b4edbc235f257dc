#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fumon {

/// The value below which a share of the values lies, 0 for none; reorders them.
template <class Number>
double percentile(std::vector<Number>& values, double share) {
    if (values.empty()) return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

}  // namespace fumon
