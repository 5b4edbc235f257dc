#pragma once

#include <bit>
#include <cstdint>

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

/// ln x for positive normal numbers x; for others a finite number without meaning. The series and
/// the reduction are those of elementary::log.
inline double log_of_normal(double x) {
    using namespace elementary::detail;
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdU;  // bits of √½
    constexpr std::uint64_t bias = 1023;
    constexpr int exponent_at = 52;
    constexpr std::uint64_t two_to_52 = 0x4330000000000000U;  // bits of 2^52
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t shifted = (bits - root_half + (bias << exponent_at)) >> exponent_at;
    const double k = std::bit_cast<double>(two_to_52 | shifted) - (0x1p52 + 1023.0);
    const auto mantissa = std::bit_cast<double>(bits - ((shifted - bias) << exponent_at));
    const double f = mantissa - 1.0;
    const double s = f / (2.0 + f);  // log(1 + f) = 2 artanh s
    const double z = s * s;
    double series = 2.0 / 23.0;
    series = series * z + 2.0 / 21.0;
    series = series * z + 2.0 / 19.0;
    series = series * z + 2.0 / 17.0;
    series = series * z + 2.0 / 15.0;
    series = series * z + 2.0 / 13.0;
    series = series * z + 2.0 / 11.0;
    series = series * z + 2.0 / 9.0;
    series = series * z + 2.0 / 7.0;
    series = series * z + 2.0 / 5.0;
    series = series * z + 2.0 / 3.0;
    return k * ln2_high + ((k * ln2_low + s * (z * series)) + 2.0 * s);
}

/// By what Stokes' drag is multiplied at the square of a particle Reynolds number (|relative
/// velocity| · d/ν): 1 + 0.15 Re^0.687, for Re below about 800 (Schiller & Naumann 1933).
inline double schiller_naumann_factor(double reynolds_squared) {
    constexpr double smallest = 1e-60;  // adds 0.15e-20: nothing
    constexpr double half_exponent = 0.687 / 2.0;
    const double square = reynolds_squared > smallest ? reynolds_squared : smallest;
    return 1.0 + 0.15 * elementary::exp(half_exponent * log_of_normal(square));
}

}  // namespace fumon::drag
