#pragma once

#include "base/elementary.h"

/// Drag on a sphere that is slower or faster than the air, as a rate: force = −m · rate · (velocity
/// of the grain − velocity of the air). Free of branches; the same bits on every
/// processor.
namespace fumon::drag {

/// Stokes' rate for a sphere of density ρ_p, 3πρνd/m = 18 ρν/(ρ_p d²), 1/s (Terada 2025, eq. 12).
/// SI units. For particle Reynolds numbers below about 1.
inline double stokes_rate(double air_density, double viscosity, double grain_density,
                          double diameter) {
    return 18.0 * air_density * viscosity / (grain_density * diameter * diameter);
}

/// ln x for positive normal numbers x, within 2 units in the last place; for others a finite number
/// without meaning. A shorter sum than elementary::log_of_normal.
inline double short_log_of_normal(double x) {
    using namespace elementary::detail;
    const auto [k, mantissa] = parts_of_normal(x);
    const double f = mantissa - 1.0;
    const double s = f / (2.0 + f);  // log(1 + f) = 2 artanh s
    const double z = s * s;
    return k * ln2_high + ((k * ln2_low + s * (z * artanh_tail(2.0 / 23.0, z))) + 2.0 * s);
}

/// By what Stokes' drag is multiplied at the square of a particle Reynolds number (|relative
/// velocity| · d/ν): 1 + 0.15 Re^0.687, for Re below about 800 (Schiller & Naumann 1933).
inline double schiller_naumann_factor(double reynolds_squared) {
    constexpr double smallest = 1e-60;  // adds 0.15e-20: nothing
    constexpr double half_exponent = 0.687 / 2.0;
    const double square = reynolds_squared > smallest ? reynolds_squared : smallest;
    return 1.0 + 0.15 * elementary::exp(half_exponent * short_log_of_normal(square));
}

}  // namespace fumon::drag
