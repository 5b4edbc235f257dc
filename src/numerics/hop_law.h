#pragma once

#include <span>
#include <vector>

namespace fumon {

/// One flight as laws see it: from which height and slope, and how long. In the units of the law.
struct HopPoint {
    double height = 0.0;
    double slope = 0.0;
    double length = 0.0;
};

/// All fits are by least squares in l over all points; R² is 1 − Σ(l − fit)² / Σ(l − mean l)²,
/// which may be negative for the laws that have no constant, and is not a number where all l are
/// equal. All throw Error where there are fewer than 3 points, or the points do not determine the
/// law (all from the same height).

/// l = a^h − 1 (Terada 2025, section 4), lengths and heights in millimetres.
struct ExponentialLaw {
    double base = 0.0;  ///< a, per unit of height
    double r_squared = 0.0;
    [[nodiscard]] double length(double height) const;
};
ExponentialLaw fit_exponential(std::span<const HopPoint> points);

/// l = c0 + c1 h, in which Nishimori & Ouchi's L0 + b h is recognised.
struct LinearLaw {
    double constant = 0.0;    ///< c0
    double per_height = 0.0;  ///< c1
    double r_squared = 0.0;
    [[nodiscard]] double length(double height) const { return constant + per_height * height; }
};
LinearLaw fit_linear(std::span<const HopPoint> points);

/// l = l0 − α tanh(∂h/∂x): the dune rule (Terada 2025, eq. 3a). Here slopes are in the units of the
/// model that will use the law, since tanh is not linear.
struct SlopeLaw {
    double constant = 0.0;  ///< l0
    double factor = 0.0;    ///< α
    double r_squared = 0.0;
};
SlopeLaw fit_slope(std::span<const HopPoint> points);

/// Mean length over mean height in bins of equal width between the lowest and the highest point;
/// empty bins are left out.
struct HopTable {
    std::vector<double> heights;  ///< rising
    std::vector<double> lengths;
    std::vector<int> counts;
};
HopTable tabulate(std::span<const HopPoint> points, int bins);

}  // namespace fumon
