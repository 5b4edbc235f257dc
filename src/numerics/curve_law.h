#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fumon {

/// The form of a law fitted to a curve.
enum class CurveFit { none, line, power, exponential, hop, cosine };

/// A law fitted to the points of a curve.
struct CurveLaw {
    CurveFit form = CurveFit::none;
    std::vector<std::pair<std::string, double>>
        values;           ///< "a", "b" …, standard errors, "r_squared"
    double start = 0.0;   ///< cosine: the curve's first x
    double length = 1.0;  ///< cosine: and its length

    [[nodiscard]] double value(const std::string& name) const;
    [[nodiscard]] double at(double x) const;
    /// "y = 1.83 x + 4.21, R² = 0.998", four digits.
    [[nodiscard]] std::string text() const;
};

/// Fits the law by least squares: in y (line, hop, cosine), in ln y (exponential) or in the decimal
/// logarithms of both (power). R² is that of what is fitted. For a cosine the points are evenly
/// spaced and rising, a whole wave apart: its length is that of the curve, points × spacing. Throws
/// Error where there are fewer points than the law needs, logarithms are wanted of what is not
/// above 0, or the x of a cosine are not even.
CurveLaw fit_law(CurveFit form, std::span<const double> x, std::span<const double> y);

}  // namespace fumon
