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

#include <cstddef>
#include <cstdint>

#include "base/elementary.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

/// The value in every lane of a V.
template <class V = Vector>
HWY_INLINE V constant(double value) {
    return hn::Set(hn::DFromV<V>(), value);
}

/// sum · x + term, in two roundings.
template <class V>
HWY_INLINE V times_plus(V sum, V x, double term) {
    return hn::Add(hn::Mul(sum, x), constant<V>(term));
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

/// b < a ? b : a, so a where one of them is no number or both are 0.
template <class V>
HWY_INLINE V smaller(V a, V b) {
    return lesser(b, a);
}

/// b > a ? b : a, likewise.
template <class V>
HWY_INLINE V larger(V a, V b) {
    return greater(b, a);
}

template <class V>
HWY_INLINE V power_of_two(V shifted) {
    constexpr std::uint64_t bias = 1023;
    constexpr int exponent_at = 52;
    const hn::RebindToUnsigned<hn::DFromV<V>> words;
    const auto biased = hn::Add(hn::BitCast(words, shifted), hn::Set(words, bias));
    return hn::BitCast(hn::DFromV<V>(), hn::ShiftLeft<exponent_at>(biased));
}

/// elementary::detail::exp_tail of several vectors.
template <class V, std::size_t n>
HWY_INLINE void exp_tails(const V (&r)[n], V (&tail)[n]) {
    for (std::size_t i = 0; i < n; ++i) {
        V p = constant<V>(1.0 / 6227020800.0);
        p = times_plus(p, r[i], 1.0 / 479001600.0);
        p = times_plus(p, r[i], 1.0 / 39916800.0);
        p = times_plus(p, r[i], 1.0 / 3628800.0);
        p = times_plus(p, r[i], 1.0 / 362880.0);
        p = times_plus(p, r[i], 1.0 / 40320.0);
        tail[i] = p;
    }
    for (std::size_t i = 0; i < n; ++i) {
        V p = tail[i];
        p = times_plus(p, r[i], 1.0 / 5040.0);
        p = times_plus(p, r[i], 1.0 / 720.0);
        p = times_plus(p, r[i], 1.0 / 120.0);
        p = times_plus(p, r[i], 1.0 / 24.0);
        p = times_plus(p, r[i], 1.0 / 6.0);
        const V r2 = hn::Mul(r[i], r[i]);
        tail[i] = hn::Add(hn::Mul(r2, constant<V>(0.5)), hn::Mul(hn::Mul(r2, r[i]), p));
    }
}

/// x − k ln 2.
template <class V>
HWY_INLINE V reduced_by_ln2(V x, V k) {
    using namespace elementary::detail;
    return hn::Sub(hn::Sub(x, hn::Mul(k, constant<V>(ln2_high))), hn::Mul(k, constant<V>(ln2_low)));
}

/// Whether all |x| are below `most`; not where one of them is no number.
template <class V, std::size_t n>
HWY_INLINE bool all_below(const V (&x)[n], double most) {
    const hn::DFromV<V> d;
    auto below = hn::Lt(hn::Abs(x[0]), constant<V>(most));
    for (std::size_t i = 1; i < n; ++i)
        below = hn::And(below, hn::Lt(hn::Abs(x[i]), constant<V>(most)));
    return hn::AllTrue(d, below);
}

/// elementary::exp, stage by stage of several vectors, in place: each stage is a short chain of
/// operations, of which a processor works on several at once. Of |x| < 700, whose powers of two
/// need not be taken in halves.
template <class V, std::size_t n>
HWY_INLINE void exp_of_usual(V (&x)[n]) {
    using namespace elementary::detail;
    const V magic = constant<V>(to_integer);
    V shifted[n];
    V tail[n];
    for (std::size_t i = 0; i < n; ++i) {
        shifted[i] = hn::Add(hn::Mul(x[i], constant<V>(log2_e)), magic);
        x[i] = reduced_by_ln2(x[i], hn::Sub(shifted[i], magic));
    }
    exp_tails(x, tail);
    for (std::size_t i = 0; i < n; ++i) {
        const V value = hn::Add(constant<V>(1.0), hn::Add(x[i], tail[i]));
        x[i] = hn::Mul(value, power_of_two(shifted[i]));
    }
}

/// The same of any x.
template <class V, std::size_t n>
HWY_INLINE void exp_of_any(V (&x)[n]) {
    using namespace elementary::detail;
    const V magic = constant<V>(to_integer);
    V k[n];
    V tail[n];
    for (std::size_t i = 0; i < n; ++i) {
        const V clamped = greater(constant<V>(-746.0), lesser(constant<V>(710.0), x[i]));
        k[i] = hn::Sub(hn::Add(hn::Mul(clamped, constant<V>(log2_e)), magic), magic);
        x[i] = reduced_by_ln2(clamped, k[i]);
    }
    exp_tails(x, tail);
    for (std::size_t i = 0; i < n; ++i) {
        const V value = hn::Add(constant<V>(1.0), hn::Add(x[i], tail[i]));
        const V half_shifted = hn::Add(hn::Mul(constant<V>(0.5), k[i]), magic);
        const V rest_shifted = hn::Add(hn::Sub(k[i], hn::Sub(half_shifted, magic)), magic);
        x[i] = hn::Mul(hn::Mul(value, power_of_two(half_shifted)), power_of_two(rest_shifted));
    }
}

/// elementary::exp of several vectors, in place.
template <class V, std::size_t n>
HWY_INLINE void exp(V (&x)[n]) {
    constexpr double usual = 700.0;
    if (HWY_LIKELY(all_below(x, usual))) {
        exp_of_usual(x);
    } else {
        exp_of_any(x);
    }
}

template <class V>
HWY_INLINE V exp(V x) {
    V one[1] = {x};
    vectors::HWY_NAMESPACE::exp(one);
    return one[0];
}

/// elementary::expm1_positive of several vectors, in place.
template <class V, std::size_t n>
HWY_INLINE void expm1_positive(V (&x)[n]) {
    using namespace elementary::detail;
    const V magic = constant<V>(to_integer);
    V shifted[n];
    V tail[n];
    for (std::size_t i = 0; i < n; ++i) {
        shifted[i] = hn::Add(hn::Mul(x[i], constant<V>(log2_e)), magic);
        x[i] = reduced_by_ln2(x[i], hn::Sub(shifted[i], magic));
    }
    exp_tails(x, tail);
    for (std::size_t i = 0; i < n; ++i) {
        const V r = x[i];
        const V scale = power_of_two(shifted[i]);
        const V sum = hn::Add(r, tail[i]);
        const V lost = hn::Sub(tail[i], hn::Sub(sum, r));
        const V whole = hn::Sub(scale, constant<V>(1.0));
        const V grown = hn::Mul(scale, sum);
        const V value = hn::Add(whole, grown);
        const V put_back = hn::Add(hn::Sub(grown, hn::Sub(value, whole)), hn::Mul(scale, lost));
        x[i] = hn::Add(value, put_back);
    }
}

/// elementary::tanh of several vectors, in place.
template <class V, std::size_t n>
HWY_INLINE void tanh(V (&x)[n]) {
    V t[n];
    for (std::size_t i = 0; i < n; ++i) {
        const V clamped = lesser(constant<V>(22.0), hn::Abs(x[i]));
        t[i] = hn::Mul(constant<V>(2.0), clamped);
    }
    expm1_positive(t);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = hn::CopySign(hn::Div(t[i], hn::Add(t[i], constant<V>(2.0))), x[i]);
}

template <class V>
HWY_INLINE V tanh(V x) {
    V one[1] = {x};
    vectors::HWY_NAMESPACE::tanh(one);
    return one[0];
}

template <class V>
HWY_INLINE V artanh_tail(V last, V z) {
    V series = last;
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

template <class V>
struct NormalParts {
    V k;
    V mantissa;
};

/// elementary::detail::parts_of_normal.
template <class V>
HWY_INLINE NormalParts<V> parts_of_normal(V x) {
    constexpr std::uint64_t one = 0x3ff0000000000000;
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t two_to_52 = 0x4330000000000000;
    constexpr std::uint64_t mantissa_bits = 0x000fffffffffffff;
    constexpr double biased = 0x1p52 + 1023.0;
    constexpr int exponent_at = 52;
    const hn::DFromV<V> doubles;
    const hn::RebindToUnsigned<hn::DFromV<V>> words;
    const auto bits = hn::Add(hn::BitCast(words, x), hn::Set(words, one - root_half));
    const auto exponent = hn::Or(hn::ShiftRight<exponent_at>(bits), hn::Set(words, two_to_52));
    const auto fraction = hn::And(bits, hn::Set(words, mantissa_bits));
    return {hn::Sub(hn::BitCast(doubles, exponent), constant<V>(biased)),
            hn::BitCast(doubles, hn::Add(fraction, hn::Set(words, root_half)))};
}

/// elementary::log_of_normal.
template <class V>
HWY_INLINE V log_of_normal(V x) {
    using namespace elementary::detail;
    const auto parts = vectors::HWY_NAMESPACE::parts_of_normal(x);
    const V k = parts.k;
    const V f = hn::Sub(parts.mantissa, constant<V>(1.0));
    const V s = hn::Div(f, hn::Add(constant<V>(2.0), f));
    const V z = hn::Mul(s, s);
    const V series =
        vectors::HWY_NAMESPACE::artanh_tail(times_plus(constant<V>(2.0 / 25.0), z, 2.0 / 23.0), z);
    const V half_square = hn::Mul(hn::Mul(constant<V>(0.5), f), f);
    const V inner = hn::Mul(s, hn::Add(half_square, hn::Mul(z, series)));
    const V low = hn::Add(inner, hn::Mul(k, constant<V>(ln2_low)));
    return hn::Sub(hn::Mul(k, constant<V>(ln2_high)), hn::Sub(hn::Sub(half_square, low), f));
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
