#pragma once

#include <limits>
#include <span>

namespace fumon {

/// The wave a₁cos(2πkx/W + a₂) + a₃ (Terada 2025, the fit of his bed shear stress), in the unit of
/// the curve.
struct StressFit {
    double mean = std::numeric_limits<double>::quiet_NaN();       ///< a₃
    double amplitude = std::numeric_limits<double>::quiet_NaN();  ///< a₁, never negative
    /// a₂, radians in (−π, π]; positive where the maximum lies upwind of x = 0, the crest of a bed
    /// that goes as cos(2πkx/W).
    double phase = std::numeric_limits<double>::quiet_NaN();
    double r_squared = std::numeric_limits<double>::quiet_NaN();
};

/// Least squares through a curve's n values at x = i·W/n, with k = `waves` of them over its width.
/// NaN throughout where k is not in 1 … (n − 1)/2. A level curve (its amplitude below 1e-9 of its
/// mean) has neither phase nor R².
StressFit fit_stress(std::span<const double> stress, int waves);

}  // namespace fumon
