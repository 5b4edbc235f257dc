#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace fumon {

/// How sand that hops so many cells along one axis is spread over three cells: by the quadratic
/// B-spline, whose first two moments are the same wherever between cells the hop ends. So the grid
/// does not show in how hops spread.
struct HopSpread {
    explicit HopSpread(double cells) {
        const double nearest = std::floor(cells + 0.5);
        const double beyond = cells - nearest;
        const double near = 0.5 - beyond;
        const double far = 0.5 + beyond;
        first = static_cast<std::int64_t>(nearest) - 1;
        shares = {0.5 * near * near, 0.75 - beyond * beyond, 0.5 * far * far};
    }

    std::int64_t first;            ///< of the three cells, from where the hop begins
    std::array<double, 3> shares;  ///< which add up to 1
};

}  // namespace fumon
