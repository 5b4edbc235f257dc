#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/fault_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/fault_vectors.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct Fault {
    WaterRow row;

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, std::size_t x) const {
        const auto h = hn::LoadU(d, row.depth + x);
        const auto u = hn::LoadU(d, row.velocity_x + x);
        const auto v = hn::LoadU(d, row.velocity_y + x);
        const auto z = hn::LoadU(d, row.bed + x);
        const auto zero = hn::Zero(d);  // times what is not finite it is no number
        const auto shallow = hn::IfThenElseZero(hn::Lt(h, zero), hn::Set(d, -1.0));
        return (shallow + (h * zero + u * zero)) + (v * zero + z * zero);
    }
};

double fault_of_row(const WaterRow& row, int count) {
    const hn::ScalableTag<double> doubles;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    const Fault fault_of{row};
    auto faults = hn::Zero(doubles);
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes) faults = faults + fault_of(doubles, x);
    double fault = hn::GetLane(hn::SumOfLanes(doubles, faults));
#pragma GCC unroll 1
    for (; x < cells; ++x) fault += hn::GetLane(fault_of(one, x));
    return fault;
}

struct Difference {
    const double* a;
    const double* b;

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, std::size_t x) const {
        return hn::Abs(hn::LoadU(d, a + x) - hn::LoadU(d, b + x));
    }
};

double largest_difference_of_row(const double* a, const double* b, int count) {
    return largest_of_row(count, Difference{a, b});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon {

HWY_EXPORT(fault_of_row);
HWY_EXPORT(largest_difference_of_row);

double fault_of_row(const WaterRow& row, int count) {
    return HWY_DYNAMIC_DISPATCH(fault_of_row)(row, count);
}

double largest_difference_of_row(const double* a, const double* b, int count) {
    return HWY_DYNAMIC_DISPATCH(largest_difference_of_row)(a, b, count);
}

}  // namespace fumon
#endif
