#pragma once

#include <concepts>

#include "base/double_double.h"
#include "base/elementary.h"

/// Angles and distances whose bits do not depend on the CPU, as base/elementary.h.
namespace fumon::elementary {

namespace detail {

/// atan(i/8) in two parts.
struct AngleOfEighths {
    double high, low;
};
inline constexpr AngleOfEighths angle_of_eighths[] = {
    {0.0, 0.0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};
/// √(x² + y²) for numbers whose squares neither over- nor underflow: Newton's step puts back what
/// rounding took from the squares.
inline double length_of(double x, double y) {
    const DoubleDouble squares = exact_product(x, x) + exact_product(y, y);
    const double root = std::sqrt(squares.high);
    if (root == 0.0) return root;
    const DoubleDouble back = exact_product(root, root);
    return root + ((squares.high - back.high) + (squares.low - back.low)) / (2.0 * root);
}

inline constexpr double pi_high = 0x1.921fb54442d18p+1;
inline constexpr double pi_low = 0x1.1a62633145c07p-53;

/// The angle of (x, y) for 0 ≤ y ≤ x, x > 0, both finite: from the nearest i/8 of y/x on, by the
/// Taylor polynomial of degree 15 in what is left (at most 1/15).
inline double angle_below_diagonal(double y, double x) {
    // Not negative, and a neighbouring i serves as well.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    const int i = static_cast<int>(8.0 * (y / x) + 0.5);
    const double eighths = 0.125 * i;
    const double t = (y - eighths * x) / (x + eighths * y);
    const double z = t * t;
    double p = -1.0 / 15.0;
    p = p * z + 1.0 / 13.0;
    p = p * z - 1.0 / 11.0;
    p = p * z + 1.0 / 9.0;
    p = p * z - 1.0 / 7.0;
    p = p * z + 1.0 / 5.0;
    p = p * z - 1.0 / 3.0;
    const AngleOfEighths& from = angle_of_eighths[i];
    return from.high + (t + (from.low + t * z * p));
}

}  // namespace detail

/// The angle of the vector (x, y) from the x axis, −π … π, within 2 units in the last place; signed
/// zeros and infinities as in IEEE 754 (those of std::atan2).
inline double atan2(double y, double x) {
    using namespace detail;
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    double across = std::fabs(y);
    double along = std::fabs(x);
    const double largest = across > along ? across : along;
    if (std::isinf(largest)) {  // a direction of its own, along an axis or a diagonal
        across = std::isinf(across) ? 1.0 : 0.0;
        along = std::isinf(along) ? 1.0 : 0.0;
    } else if (largest > 0x1p1000 || largest < 0x1p-900) {
        const double scale = largest > 1.0 ? 0x1p-100 : 0x1p100;
        across *= scale;
        along *= scale;
    }
    double angle = 0.0;
    if (across <= along) {
        angle = across > 0.0 ? angle_below_diagonal(across, along) : 0.0;
        if (std::signbit(x)) angle = pi_high - (angle - pi_low);
    } else {
        const double rest = along > 0.0 ? angle_below_diagonal(along, across) : 0.0;
        const double half_low = 0.5 * pi_low;
        angle =
            std::signbit(x) ? 0.5 * pi_high + (rest + half_low) : 0.5 * pi_high - (rest - half_low);
    }
    return std::copysign(angle, y);
}

/// Arc tangent, −π/2 … π/2, within 2 units in the last place.
inline double atan(double x) {
    return atan2(x, 1.0);
}

/// Arc tangent of 0 ≤ t ≤ 1 within 1e-5 radians (Abramowitz & Stegun 4.4.49), for what is only
/// looked at: cheap, and loops over it vectorise.
template <std::floating_point Real>
constexpr Real rough_atan(Real t) {
    const Real square = t * t;
    return t * (Real(0.9998660) +
                square * (Real(-0.3302995) +
                          square * (Real(0.1801410) +
                                    square * (Real(-0.0851330) + square * Real(0.0208351)))));
}

/// √(x² + y²) without overflow on the way, within 1 unit in the last place.
inline double hypot(double x, double y) {
    if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
    const double larger = std::fabs(x) > std::fabs(y) ? std::fabs(x) : std::fabs(y);
    const double scale = larger > 0x1p500 ? 0x1p-600 : larger < 0x1p-400 ? 0x1p600 : 1.0;
    return detail::length_of(x * scale, y * scale) / scale;
}

}  // namespace fumon::elementary
