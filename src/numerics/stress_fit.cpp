#include "numerics/stress_fit.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/elementary_angle.h"

namespace fumon {

StressFit fit_stress(std::span<const double> stress, int waves) {
    StressFit fit;
    const auto count = static_cast<int>(stress.size());
    if (waves < 1 || 2 * waves >= count) return fit;
    const double angle = 2.0 * std::numbers::pi * waves / count;
    double sum = 0.0;
    for (const double value : stress) sum += value;
    const double mean = sum / count;
    // On whole waves cosine, sine and 1 are orthogonal: each coefficient is a plain mean.
    double cosine = 0.0;
    double sine = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double departure = stress[static_cast<std::size_t>(i)] - mean;
        cosine += departure * elementary::cos(angle * i);
        sine += departure * elementary::sin(angle * i);
        squares += departure * departure;
    }
    cosine *= 2.0 / count;
    sine *= 2.0 / count;
    fit.mean = mean;
    fit.amplitude = elementary::hypot(cosine, sine);
    constexpr double rounding = 1e-9;
    if (!(fit.amplitude > rounding * std::abs(mean))) return fit;
    fit.phase = elementary::atan2(-sine, cosine);
    fit.r_squared = 0.5 * count * fit.amplitude * fit.amplitude / squares;
    return fit;
}

}  // namespace fumon
