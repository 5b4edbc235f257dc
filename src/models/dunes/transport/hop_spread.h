#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fumon {

/// How sand that hops so many cells along one axis is spread over three cells, so that its mean is
/// where it hops: by the quadratic B-spline, whose variance of ¼ of a cell² is the same wherever
/// between cells the hop ends, so that the grid does not show in how hops spread.
struct HopSpread {
    explicit HopSpread(double cells) {
        const double nearest = std::floor(cells + 0.5);
        const double beyond = cells - nearest;
        const double near = 0.5 - beyond;
        const double far = 0.5 + beyond;
        first = static_cast<std::int64_t>(nearest) - 1;
        shares = {0.5 * near * near, 0.75 - beyond * beyond, 0.5 * far * far};
    }

    /// With another variance, cells²; a greater one where that would take a share below 0.
    HopSpread(double cells, double variance) : HopSpread(cells) {
        constexpr double of_spline = 0.25;
        if (variance == of_spline) return;
        const double beyond = cells - std::floor(cells + 0.5);
        const double square = beyond * beyond;
        const double second = std::max(variance + square, std::abs(beyond));
        shares = {0.5 * (second - beyond), 1.0 - second, 0.5 * (second + beyond)};
    }

    std::int64_t first;            ///< of the three cells, from where the hop begins
    std::array<double, 3> shares;  ///< which add up to 1
};

}  // namespace fumon
