#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon::test {

/// A grid's values, row by row from the south.
inline std::vector<double> values_of(const Grid& grid) {
    return {grid.values().begin(), grid.values().end()};
}

}  // namespace fumon::test
