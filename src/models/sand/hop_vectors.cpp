#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/sand/hop_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/sand/hop_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::hop_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Within [0, 2^30], NaN included.
HWY_INLINE Vector usable(Vector length) {
    const Vector cut = lesser(length, constant(1073741824.0));
    return hn::IfThenElseZero(hn::Gt(cut, hn::Zero(Doubles())), cut);
}

void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out) {
    const auto of_difference = [factor](Vector l, Vector r) HWY_ATTR {
        return vectors::HWY_NAMESPACE::tanh(hn::Mul(constant(factor), hn::Sub(r, l)));
    };
    for_each_cell(count, out, of_difference, left, right);
}

void linear(const double* in, double base, double factor, int count, double* out) {
    const auto length = [base, factor](Vector x) HWY_ATTR {
        return usable(hn::Add(constant(base), hn::Mul(constant(factor), x)));
    };
    for_each_cell(count, out, length, in);
}

void linear_truncated(const double* in, double base, double factor, int count, double* out) {
    const auto length = [base, factor](Vector x) HWY_ATTR {
        const Vector grown = hn::Trunc(usable(hn::Mul(constant(factor), x)));
        return usable(hn::Add(constant(base), grown));
    };
    for_each_cell(count, out, length, in);
}

void exponential(const double* in, double scale, double rate, int count, double* out) {
    const auto length = [scale, rate](Vector x) HWY_ATTR {
        const Vector power = vectors::HWY_NAMESPACE::exp(hn::Mul(constant(rate), x));
        return usable(hn::Mul(constant(scale), hn::Sub(power, constant(1.0))));
    };
    for_each_cell(count, out, length, in);
}

void limited_amounts(const double* height, double amount, int count, double* out) {
    const auto carried = [amount](Vector h) HWY_ATTR {
        return lesser(constant(amount), greater(h, hn::Zero(Doubles())));
    };
    for_each_cell(count, out, carried, height);
}

void slope_amounts(const double* height, const double* slope_tanh, double base, double factor,
                   bool limited, int count, double* out) {
    const auto carried = [base, factor, limited](Vector h, Vector slope) HWY_ATTR {
        const Vector none = hn::Zero(Doubles());
        const Vector wanted =
            greater(hn::Add(constant(base), hn::Mul(constant(factor), slope)), none);
        return limited ? lesser(wanted, greater(h, none)) : wanted;
    };
    for_each_cell(count, out, carried, height, slope_tanh);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::hop_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::hop_vectors {

HWY_EXPORT(tanh_of_differences);
HWY_EXPORT(linear);
HWY_EXPORT(linear_truncated);
HWY_EXPORT(exponential);
HWY_EXPORT(limited_amounts);
HWY_EXPORT(slope_amounts);

void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out) {
    HWY_DYNAMIC_DISPATCH(tanh_of_differences)(left, right, factor, count, out);
}

void linear(const double* in, double base, double factor, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(linear)(in, base, factor, count, out);
}

void linear_truncated(const double* in, double base, double factor, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(linear_truncated)(in, base, factor, count, out);
}

void exponential(const double* in, double scale, double rate, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(exponential)(in, scale, rate, count, out);
}

void limited_amounts(const double* height, double amount, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(limited_amounts)(height, amount, count, out);
}

void slope_amounts(const double* height, const double* slope_tanh, double base, double factor,
                   bool limited, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(slope_amounts)(height, slope_tanh, base, factor, limited, count, out);
}

}  // namespace fumon::hop_vectors
#endif
