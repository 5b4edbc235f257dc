// Loops over rows of doubles, compiled once for each target (see vectors/target.h).

#if defined(FUMON_VECTORS_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_VECTORS_ROWS_INL_H
#undef FUMON_VECTORS_ROWS_INL_H
#else
#define FUMON_VECTORS_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace fumon::vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// out[x] = function(in[x]…) for 0 ≤ x < count, the cells of a vector side by side and in any
/// order. `out` may be one of the rows `in`. Past the last whole vector the function sees zeros
/// too.
template <class Function, class... In>
HWY_INLINE void for_each_cell(int count, double* out, const Function& function, const In*... in) {
    const hn::ScalableTag<double> doubles;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes)
        hn::StoreU(function(hn::LoadU(doubles, in + x)...), doubles, out + x);
    const std::size_t rest = cells - x;
    if (rest == 0) return;
    const auto load = [&](const double* from) HWY_ATTR {
        HWY_ALIGN double some[lanes] = {};
        for (std::size_t k = 0; k < rest; ++k) some[k] = from[x + k];
        return hn::Load(doubles, some);
    };
    HWY_ALIGN double some[lanes];
    hn::Store(function(load(in)...), doubles, some);
    for (std::size_t k = 0; k < rest; ++k) out[x + k] = some[k];
}

/// Calls loop(d, x) for the cells of a row: those of a vector from x on by the tag d of whole
/// vectors, and past the last whole one cell after cell by a tag of one lane.
template <class Loop>
HWY_INLINE void for_each_vector(int count, const Loop& loop) {
    const hn::ScalableTag<double> doubles;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes) loop(doubles, x);
#pragma GCC unroll 1
    for (; x < cells; ++x) loop(one, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
