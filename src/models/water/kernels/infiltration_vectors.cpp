#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/infiltration_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/infiltration_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::infiltration {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct Take {
    double most;
    double* depth;
    double* taken;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto there = hn::LoadU(d, depth + x);
        const auto gone = lesser(hn::Set(d, most), there);
        hn::StoreU(gone, d, taken + x);
        hn::StoreU(there - gone, d, depth + x);
    }
};

struct GreenAmpt {
    double conductivity;
    double suction;
    double* depth;
    double* total;
    double* taken;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto there = hn::LoadU(d, depth + x);
        const auto before = hn::LoadU(d, total + x);
        const auto grown = before + hn::Set(d, conductivity);
        const auto root = hn::Sqrt(grown * grown + hn::Set(d, 4.0 * conductivity * suction));
        const auto could = hn::Set(d, 0.5) * (grown + root) - before;
        const auto gone = lesser(greater(could, hn::Zero(d)), there);
        hn::StoreU(gone, d, taken + x);
        hn::StoreU(before + gone, d, total + x);
        hn::StoreU(there - gone, d, depth + x);
    }
};

void take_row(double most, int count, double* depth, double* taken) {
    for_each_vector(count, Take{most, depth, taken});
}

void green_ampt_row(double conductivity, double suction, int count, double* depth, double* total,
                    double* taken) {
    for_each_vector(count, GreenAmpt{conductivity, suction, depth, total, taken});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::infiltration
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::infiltration {

HWY_EXPORT(take_row);
HWY_EXPORT(green_ampt_row);

void take_row(double most, int count, double* depth, double* taken) {
    HWY_DYNAMIC_DISPATCH(take_row)(most, count, depth, taken);
}

void green_ampt_row(double conductivity, double suction, int count, double* depth, double* total,
                    double* taken) {
    HWY_DYNAMIC_DISPATCH(green_ampt_row)(conductivity, suction, count, depth, total, taken);
}

}  // namespace fumon::infiltration
#endif
