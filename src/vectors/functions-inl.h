// Elementary functions of vectors, compiled once for each target (see vectors/target.h): the
// formulas of base/elementary.h, operation by operation, so that every lane has its bits. No fused
// multiplication and addition.

#if defined(FUMON_VECTORS_FUNCTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_VECTORS_FUNCTIONS_INL_H
#undef FUMON_VECTORS_FUNCTIONS_INL_H
#else
#define FUMON_VECTORS_FUNCTIONS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "base/elementary.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;
using Words = hn::RebindToUnsigned<Doubles>;

HWY_INLINE Vector constant(double value) {
    return hn::Set(Doubles(), value);
}

/// sum · x + term, in two roundings.
HWY_INLINE Vector times_plus(Vector sum, Vector x, double term) {
    return hn::Add(hn::Mul(sum, x), constant(term));
}

/// a < b ? a : b, so b where one of them is no number or both are 0. What x86 calls a minimum.
template <class V>
HWY_INLINE V lesser(V a, V b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    return hn::Min(a, b);
#else
    return hn::IfThenElse(hn::Lt(a, b), a, b);
#endif
}

/// a > b ? a : b, likewise.
template <class V>
HWY_INLINE V greater(V a, V b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    return hn::Max(a, b);
#else
    return hn::IfThenElse(hn::Gt(a, b), a, b);
#endif
}

HWY_INLINE Vector power_of_two(Vector shifted) {
    constexpr std::uint64_t bias = 1023;
    constexpr int exponent_at = 52;
    const Words words;
    const auto biased = hn::Add(hn::BitCast(words, shifted), hn::Set(words, bias));
    return hn::BitCast(Doubles(), hn::ShiftLeft<exponent_at>(biased));
}

HWY_INLINE Vector exp_tail(Vector r) {
    const Vector r2 = hn::Mul(r, r);
    Vector p = constant(1.0 / 6227020800.0);
    p = times_plus(p, r, 1.0 / 479001600.0);
    p = times_plus(p, r, 1.0 / 39916800.0);
    p = times_plus(p, r, 1.0 / 3628800.0);
    p = times_plus(p, r, 1.0 / 362880.0);
    p = times_plus(p, r, 1.0 / 40320.0);
    p = times_plus(p, r, 1.0 / 5040.0);
    p = times_plus(p, r, 1.0 / 720.0);
    p = times_plus(p, r, 1.0 / 120.0);
    p = times_plus(p, r, 1.0 / 24.0);
    p = times_plus(p, r, 1.0 / 6.0);
    return hn::Add(hn::Mul(r2, constant(0.5)), hn::Mul(hn::Mul(r2, r), p));
}

/// x − k ln 2.
HWY_INLINE Vector without_twos(Vector x, Vector k) {
    using namespace elementary::detail;
    return hn::Sub(hn::Sub(x, hn::Mul(k, constant(ln2_high))), hn::Mul(k, constant(ln2_low)));
}

/// elementary::exp.
HWY_INLINE Vector exp(Vector x) {
    using namespace elementary::detail;
    const Vector magic = constant(to_integer);
    Vector clamped = hn::IfThenElse(hn::Gt(x, constant(710.0)), constant(710.0), x);
    clamped = hn::IfThenElse(hn::Lt(clamped, constant(-746.0)), constant(-746.0), clamped);
    const Vector k = hn::Sub(hn::Add(hn::Mul(clamped, constant(log2_e)), magic), magic);
    const Vector r = without_twos(clamped, k);
    const Vector value = hn::Add(constant(1.0), hn::Add(r, exp_tail(r)));
    const Vector half_shifted = hn::Add(hn::Mul(constant(0.5), k), magic);
    const Vector rest_shifted = hn::Add(hn::Sub(k, hn::Sub(half_shifted, magic)), magic);
    return hn::Mul(hn::Mul(value, power_of_two(half_shifted)), power_of_two(rest_shifted));
}

/// elementary::expm1_positive.
HWY_INLINE Vector expm1_positive(Vector x) {
    using namespace elementary::detail;
    const Vector magic = constant(to_integer);
    const Vector shifted = hn::Add(hn::Mul(x, constant(log2_e)), magic);
    const Vector r = without_twos(x, hn::Sub(shifted, magic));
    const Vector scale = power_of_two(shifted);
    const Vector tail = exp_tail(r);
    const Vector sum = hn::Add(r, tail);
    const Vector lost = hn::Sub(tail, hn::Sub(sum, r));
    const Vector whole = hn::Sub(scale, constant(1.0));
    const Vector grown = hn::Mul(scale, sum);
    const Vector value = hn::Add(whole, grown);
    const Vector put_back = hn::Add(hn::Sub(grown, hn::Sub(value, whole)), hn::Mul(scale, lost));
    return hn::Add(value, put_back);
}

/// elementary::tanh.
HWY_INLINE Vector tanh(Vector x) {
    const Vector size = hn::Abs(x);
    const Vector saturated = constant(22.0);
    const Vector clamped = hn::IfThenElse(hn::Gt(size, saturated), saturated, size);
    const Vector t = expm1_positive(hn::Mul(constant(2.0), clamped));
    return hn::CopySign(hn::Div(t, hn::Add(t, constant(2.0))), x);
}

HWY_INLINE Vector artanh_tail(Vector last, Vector z) {
    Vector series = last;
    series = times_plus(series, z, 2.0 / 21.0);
    series = times_plus(series, z, 2.0 / 19.0);
    series = times_plus(series, z, 2.0 / 17.0);
    series = times_plus(series, z, 2.0 / 15.0);
    series = times_plus(series, z, 2.0 / 13.0);
    series = times_plus(series, z, 2.0 / 11.0);
    series = times_plus(series, z, 2.0 / 9.0);
    series = times_plus(series, z, 2.0 / 7.0);
    series = times_plus(series, z, 2.0 / 5.0);
    series = times_plus(series, z, 2.0 / 3.0);
    return series;
}

struct NormalParts {
    Vector k;
    Vector mantissa;
};

/// elementary::detail::parts_of_normal.
HWY_INLINE NormalParts parts_of_normal(Vector x) {
    constexpr std::uint64_t one = 0x3ff0000000000000;
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t two_to_52 = 0x4330000000000000;
    constexpr std::uint64_t mantissa_bits = 0x000fffffffffffff;
    constexpr double biased = 0x1p52 + 1023.0;
    constexpr int exponent_at = 52;
    const Doubles doubles;
    const Words words;
    const auto bits = hn::Add(hn::BitCast(words, x), hn::Set(words, one - root_half));
    const auto exponent = hn::Or(hn::ShiftRight<exponent_at>(bits), hn::Set(words, two_to_52));
    const auto fraction = hn::And(bits, hn::Set(words, mantissa_bits));
    return {hn::Sub(hn::BitCast(doubles, exponent), constant(biased)),
            hn::BitCast(doubles, hn::Add(fraction, hn::Set(words, root_half)))};
}

/// elementary::log_of_normal.
HWY_INLINE Vector log_of_normal(Vector x) {
    using namespace elementary::detail;
    const auto parts = vectors::HWY_NAMESPACE::parts_of_normal(x);
    const Vector k = parts.k;
    const Vector f = hn::Sub(parts.mantissa, constant(1.0));
    const Vector s = hn::Div(f, hn::Add(constant(2.0), f));
    const Vector z = hn::Mul(s, s);
    const Vector series =
        vectors::HWY_NAMESPACE::artanh_tail(times_plus(constant(2.0 / 25.0), z, 2.0 / 23.0), z);
    const Vector half_square = hn::Mul(hn::Mul(constant(0.5), f), f);
    const Vector inner = hn::Mul(s, hn::Add(half_square, hn::Mul(z, series)));
    const Vector low = hn::Add(inner, hn::Mul(k, constant(ln2_low)));
    return hn::Sub(hn::Mul(k, constant(ln2_high)), hn::Sub(hn::Sub(half_square, low), f));
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
