#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

/// Elementary functions whose bits do not depend on the CPU: plain IEEE double arithmetic in a
/// fixed order, never the system library's (whose results change with the presence of FMA). Within
/// 2 units in the last place of the true value unless said; tested against long double. exp,
/// expm1_positive, tanh and log_of_normal are free of branches, so that loops over them vectorise
/// and give the very same bits.
namespace fumon::elementary {

namespace detail {

inline constexpr double log2_e = 0x1.71547652b82fep0;
inline constexpr double ln2_high = 0x1.62e42feep-1;  // 32 bits: products with |k| < 2^20 are exact
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;  // ln 2 − ln2_high
inline constexpr double to_integer =
    0x1.8p52;  // adding it leaves a rounded integer in the low bits
inline constexpr double pi_half_high =
    0x1.921fb544p0;  // π/2 in three parts of 33 bits and the rest
inline constexpr double pi_half_middle = 0x1.0b4611a6p-34;
inline constexpr double pi_half_low = 0x1.3198a2e037073p-69;

/// 2^k for the integer k held in the low bits of `shifted` = k + to_integer, −1022 ≤ k ≤ 1023.
inline double power_of_two(double shifted) {
    constexpr std::uint64_t bias = 1023;
    constexpr int exponent_at = 52;
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + bias) << exponent_at);
}

/// e^r − 1 − r for |r| ≤ ln 2 / 2, by its Taylor polynomial of degree 13 (remainder below 2^-58).
inline double exp_tail(double r) {
    const double r2 = r * r;
    double p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    return r2 * 0.5 + r2 * r * p;
}

/// sin r for |r| ≤ π/4, by its Taylor polynomial of degree 17.
inline double sin_near_zero(double r) {
    const double z = r * r;
    double p = 1.0 / 355687428096000.0;
    p = p * z - 1.0 / 1307674368000.0;
    p = p * z + 1.0 / 6227020800.0;
    p = p * z - 1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return r + r * z * p;
}

/// cos r for |r| ≤ π/4, by its Taylor polynomial of degree 18.
inline double cos_near_zero(double r) {
    const double z = r * r;
    double p = -1.0 / 6402373705728000.0;
    p = p * z + 1.0 / 20922789888000.0;
    p = p * z - 1.0 / 87178291200.0;
    p = p * z + 1.0 / 479001600.0;
    p = p * z - 1.0 / 3628800.0;
    p = p * z + 1.0 / 40320.0;
    p = p * z - 1.0 / 720.0;
    p = p * z + 1.0 / 24.0;
    const double half = 0.5 * z;
    const double rounded = 1.0 - half;
    return rounded + (((1.0 - rounded) - half) + z * z * p);  // what 1 − z/2 lost is put back
}

/// sin (quarter turns later for cos) by reduction to a quarter turn.
inline double sine(double x, int quarters_later) {
    constexpr double largest = 1e6;  // up to here the reduction is exact enough
    if (!(std::fabs(x) <= largest)) return std::numeric_limits<double>::quiet_NaN();
    const double shifted = x * (2.0 / 3.14159265358979323846) + to_integer;
    const double k = shifted - to_integer;
    const double r = ((x - k * pi_half_high) - k * pi_half_middle) - k * pi_half_low;
    const auto quarter = (static_cast<std::int64_t>(k) + quarters_later) & 3;
    const double value = (quarter & 1) != 0 ? cos_near_zero(r) : sin_near_zero(r);
    return (quarter & 2) != 0 ? -value : value;
}

/// A normal positive number as 2^k · mantissa.
struct NormalParts {
    double k;
    double mantissa;  ///< in [√½, √2)
};

inline NormalParts parts_of_normal(double x) {
    constexpr std::uint64_t one = 0x3ff0000000000000;        // the bits of 1
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;  // the bits of √½
    constexpr std::uint64_t two_to_52 = 0x4330000000000000;  // the bits of 2^52
    constexpr std::uint64_t mantissa_bits = 0x000fffffffffffff;
    constexpr double biased = 0x1p52 + 1023.0;
    constexpr int exponent_at = 52;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + (one - root_half);
    return {std::bit_cast<double>((bits >> exponent_at) | two_to_52) - biased,
            std::bit_cast<double>((bits & mantissa_bits) + root_half)};
}

/// 2/3 + 2/5·z + … + 2/21·z^9 + last·z^10: with s = √z, 2 artanh s = 2s + s·z times this.
inline double artanh_tail(double last, double z) {
    double series = last;
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
    return series;
}

}  // namespace detail

/// e^x. Overflows to infinity and underflows through subnormal numbers to 0 as IEEE arithmetic
/// does.
inline double exp(double x) {
    using namespace detail;
    constexpr double highest = 710.0;  // e^710 is infinite
    constexpr double lowest = -746.0;  // e^-746 is 0
    double clamped = x > highest ? highest : x;
    clamped = clamped < lowest ? lowest : clamped;
    const double k = (clamped * log2_e + to_integer) - to_integer;
    const double r = (clamped - k * ln2_high) - k * ln2_low;
    const double value = 1.0 + (r + exp_tail(r));
    const double half_shifted = 0.5 * k + to_integer;  // in two halves: 2^k alone may overflow
    const double rest_shifted = (k - (half_shifted - to_integer)) + to_integer;
    return value * power_of_two(half_shifted) * power_of_two(rest_shifted);
}

/// e^x − 1 for 0 ≤ x ≤ 700, without cancellation near 0.
inline double expm1_positive(double x) {
    using namespace detail;
    const double shifted = x * log2_e + to_integer;
    const double k = shifted - to_integer;
    const double r = (x - k * ln2_high) - k * ln2_low;
    const double scale = power_of_two(shifted);
    const double tail = exp_tail(r);
    const double sum = r + tail;  // e^r − 1; what each addition rounds away is carried along
    const double lost = tail - (sum - r);
    const double whole = scale - 1.0;
    const double value = whole + scale * sum;
    return value + ((scale * sum - (value - whole)) + scale * lost);
}

/// Hyperbolic tangent, within 3 units in the last place.
inline double tanh(double x) {
    constexpr double saturated = 22.0;  // 1 − tanh 22 is below half a unit in the last place
    const double size = std::fabs(x);
    const double clamped = size > saturated ? saturated : size;
    const double t = expm1_positive(2.0 * clamped);
    return std::copysign(t / (t + 2.0), x);
}

/// Natural logarithm of a normal positive number (at least 2^-1022); anything else gives a value
/// without meaning. Free of branches, so that loops over it vectorise.
inline double log_of_normal(double x) {
    using namespace detail;
    const auto [k, mantissa] = parts_of_normal(x);
    const double f = mantissa - 1.0;
    const double s = f / (2.0 + f);  // log(1 + f) = 2 artanh s
    const double z = s * s;
    const double series = artanh_tail(2.0 / 25.0 * z + 2.0 / 23.0, z);
    const double half_square = 0.5 * f * f;
    return k * ln2_high - ((half_square - (s * (half_square + z * series) + k * ln2_low)) - f);
}

/// Natural logarithm: −infinity at 0, not a number below.
inline double log(double x) {
    if (!(x > 0.0)) {
        return x == 0.0 ? -std::numeric_limits<double>::infinity()
                        : std::numeric_limits<double>::quiet_NaN();
    }
    if (x == std::numeric_limits<double>::infinity()) return x;
    constexpr double smallest_normal = 0x1p-1022;
    if (x >= smallest_normal) return log_of_normal(x);
    constexpr double shift = 54.0;
    return log_of_normal(x * 0x1p54) - shift * 0x1.62e42fefa39efp-1;
}

/// Sine of an angle in radians, |x| ≤ 10^6; not a number beyond.
inline double sin(double x) {
    return detail::sine(x, 0);
}

/// Cosine of an angle in radians, |x| ≤ 10^6; not a number beyond.
inline double cos(double x) {
    return detail::sine(x, 1);
}

}  // namespace fumon::elementary
