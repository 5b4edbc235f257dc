#include "base/elementary_power.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace fumon::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr DoubleDouble one_by_ln10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/// Natural logarithm of a finite x > 0: k ln 2 + 2 artanh s, s = f / (2 + f), of the mantissa 1 + f
/// in [√½, √2). Its relative error is below 2^-95, near x = 1 too.
DoubleDouble precise_log(double x) {
    constexpr int terms = 21;  // s² < 0.0295: the rest is below 2^-110
    constexpr double root_half = 0.70710678118654752;
    int k = 0;
    double mantissa = std::frexp(x, &k);  // in [½, 1)
    if (mantissa < root_half) {
        mantissa *= 2.0;
        --k;
    }
    const double f = mantissa - 1.0;
    const DoubleDouble s = DoubleDouble{f, 0.0} / exact_sum(2.0, f);
    const DoubleDouble square = s * s;
    DoubleDouble series{1.0 / (2.0 * terms + 1.0), 0.0};
    for (int n = terms - 1; n >= 0; --n)
        series = DoubleDouble{1.0, 0.0} / DoubleDouble{2.0 * n + 1.0, 0.0} + square * series;
    return ln2 * static_cast<double>(k) + s * series * 2.0;
}

/// (high + low) 2^k for a sum above 0, rounded once: to the coarser spacing of subnormal numbers
/// too.
double scaled(DoubleDouble value, int k) {
    constexpr int smallest_exponent = -1074;  // of subnormal numbers
    constexpr int precision = 52;
    int own = 0;
    std::frexp(value.high, &own);  // value in [½, 1) · 2^own
    k += own;
    value = {std::ldexp(value.high, -own), std::ldexp(value.low, -own)};
    if (k > smallest_exponent + precision) return std::ldexp(value.high, k);
    if (k < smallest_exponent) return 0.0;
    // Numbers near `shift` are as far apart as the subnormal ones are after scaling.
    const double shift = std::ldexp(1.0, precision + smallest_exponent - k);
    const DoubleDouble sum = exact_sum(shift, value.high);
    return std::ldexp((sum.high + (sum.low + value.low)) - shift, k);
}

/// e^x, rounded, for |x| < 2000: 2^k times the Taylor series of the rest.
double rounded_exp(const DoubleDouble& x) {
    constexpr int terms = 24;  // |rest| < 0.35: what is left out is below 2^-120
    const double k = std::floor(x.high / ln2.high + 0.5);
    const DoubleDouble rest = x + ln2 * -k;
    DoubleDouble series{1.0, 0.0};
    for (int n = terms; n >= 1; --n) {
        series = DoubleDouble{1.0, 0.0} + rest * series / DoubleDouble{static_cast<double>(n), 0.0};
    }
    return scaled(series, static_cast<int>(k));
}

bool is_whole(double x) {
    return std::floor(x) == x;
}

bool is_odd(double x) {
    return is_whole(x) && std::fabs(x) < 0x1p53 && (static_cast<std::int64_t>(x) & 1) != 0;
}

/// base^exponent for a whole exponent in 1 … 40, by products that are exact as long as the power
/// has at most 106 bits: so a power halfway between two doubles goes to the even one. (Later powers
/// of anything but 2^k are never halfway.)
double whole_power(double base, int exponent) {
    int k = 0;
    const double mantissa = std::frexp(base, &k);
    DoubleDouble power{1.0, 0.0};
    for (int i = 0; i < exponent; ++i) power = power * mantissa;
    return scaled(power, k * exponent);
}

/// base^exponent of a finite base > 0 and an exponent other than 0.
double power_of_positive(double base, double exponent) {
    constexpr double beyond = 800.0;  // e^±800 is infinite or 0
    constexpr double longest_product = 40.0;
    const DoubleDouble logarithm = precise_log(base);
    const double estimate = exponent * logarithm.high;
    if (!(std::fabs(estimate) < beyond)) return estimate > 0.0 ? infinity : 0.0;
    int k = 0;
    if (std::frexp(base, &k) == 0.5 && is_whole((k - 1) * exponent))
        return std::ldexp(1.0, static_cast<int>((k - 1) * exponent));
    if (exponent > 0.0 && exponent <= longest_product && is_whole(exponent))
        return whole_power(base, static_cast<int>(exponent));
    return rounded_exp(logarithm * exponent);
}

}  // namespace

double pow(double base, double exponent) {
    if (base == 1.0 || exponent == 0.0) return 1.0;
    if (std::isnan(base) || std::isnan(exponent)) return not_a_number;
    const double size = std::fabs(base);
    if (std::isinf(exponent)) {
        if (size == 1.0) return 1.0;
        return (size > 1.0) == (exponent > 0.0) ? infinity : 0.0;
    }
    const double sign = std::signbit(base) && is_odd(exponent) ? -1.0 : 1.0;
    if (size == 0.0) return exponent > 0.0 ? sign * 0.0 : sign * infinity;
    if (std::isinf(size)) return exponent > 0.0 ? sign * infinity : sign * 0.0;
    if (base < 0.0 && !is_whole(exponent)) return not_a_number;
    return size == 1.0 ? sign : sign * power_of_positive(size, exponent);
}

double log10(double x) {
    if (!(x > 0.0)) return x == 0.0 ? -infinity : not_a_number;
    if (std::isinf(x)) return x;
    return (precise_log(x) * one_by_ln10).high;
}

}  // namespace fumon::elementary
