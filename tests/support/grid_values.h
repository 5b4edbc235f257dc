#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon::test {

/// A grid's values, row by row from the south.
inline std::vector<double> values_of(const Grid& grid) {
    return {grid.values().begin(), grid.values().end()};
}

inline double sum(const Grid& grid) {
    long double total = 0.0;
    for (const double value : grid.values()) total += value;
    return static_cast<double>(total);
}

}  // namespace fumon::test
