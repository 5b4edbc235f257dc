#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/sediment_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/sediment_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::sediment {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

HWY_INLINE Vector log_of_square(Vector square) {
    return log_of_normal(greater(square, constant(tiny)));
}

void stress_row(const FluxLaw& law, const double* u, const double* v, int count, double* excess) {
    const double half_q = 0.5 * law.velocity_exponent;
    const double half_gamma = 0.5 * law.slope_exponent;
    const auto stress_above = [&law, half_q, half_gamma](Vector steepness, Vector along_x,
                                                         Vector along_y) HWY_ATTR {
        const Vector speed = hn::Add(hn::Mul(along_x, along_x), hn::Mul(along_y, along_y));
        const Vector power = vectors::HWY_NAMESPACE::exp(
            hn::Add(hn::Mul(constant(half_q), log_of_square(speed)),
                    hn::Mul(constant(half_gamma), log_of_square(steepness))));
        const Vector stress =
            hn::Sub(hn::Mul(constant(law.stress_factor), power), constant(law.critical_stress));
        const Vector above = greater(stress, hn::Zero(Doubles()));
        return hn::IfThenElseZero(hn::Gt(speed, constant(tiny)), above);
    };
    for_each_cell(count, excess, stress_above, excess, u, v);
}

void raise_row(double exponent, int count, double* values) {
    const auto raised = [exponent](Vector value) HWY_ATTR {
        const Vector power =
            vectors::HWY_NAMESPACE::exp(hn::Mul(constant(exponent), log_of_square(value)));
        return hn::IfThenElseZero(hn::Gt(value, constant(tiny)), power);
    };
    for_each_cell(count, values, raised, values);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::sediment
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::sediment {

HWY_EXPORT(stress_row);
HWY_EXPORT(raise_row);

void stress_row(const FluxLaw& law, const double* u, const double* v, int count, double* excess) {
    HWY_DYNAMIC_DISPATCH(stress_row)(law, u, v, count, excess);
}

void raise_row(double exponent, int count, double* values) {
    HWY_DYNAMIC_DISPATCH(raise_row)(exponent, count, values);
}

}  // namespace fumon::sediment
#endif
