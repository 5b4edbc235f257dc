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

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
