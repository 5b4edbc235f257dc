#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace fumon {

/// A straight line y = intercept + slope · x. Not a number where there are fewer than two points,
/// or all stand at one x; the standard error fewer than three.
struct LineFit {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double slope = none;
    double standard_error = none;  ///< of the slope, from the scatter about the line
    double intercept = none;
    double r_squared = none;  ///< not a number where all y are the same
    std::int64_t points = 0;
};

/// Least squares in y through all points; as many y as x.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// The same through the decimal logarithms of points whose x and y are above 0: y = 10^intercept ·
/// x^slope.
LineFit fit_line_in_logarithms(std::span<const double> x, std::span<const double> y);

}  // namespace fumon
