// Loops over rows of doubles, compiled once for each target (see vectors/target.h).

#if defined(FUMON_VECTORS_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_VECTORS_ROWS_INL_H
#undef FUMON_VECTORS_ROWS_INL_H
#else
#define FUMON_VECTORS_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <type_traits>

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

/// The same for loops that change nothing they read: past the last whole vector they get the row's
/// last cells once more, as far as it has a vector of them.
template <class Loop>
HWY_INLINE void for_each_vector_overlapping(int count, const Loop& loop) {
    const hn::ScalableTag<double> doubles;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    if (cells < lanes) {
        for_each_vector(count, loop);
        return;
    }
    for (std::size_t x = 0; x + lanes < cells; x += lanes) loop(doubles, x);
    loop(doubles, cells - lanes);
}

/// The largest of function(d, x) over a row as for_each_vector goes, 0 where none is above 0; what
/// is no number is passed over.
template <class Function>
HWY_INLINE double largest_of_row(int count, const Function& function) {
    const hn::ScalableTag<double> doubles;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    auto most = hn::Zero(doubles);
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes) {
        const auto here = function(doubles, x);
        most = hn::IfThenElse(hn::Gt(here, most), here, most);
    }
    HWY_ALIGN double some[lanes];
    hn::Store(most, doubles, some);
    double largest = 0.0;
    for (const double lane : some) largest = lane > largest ? lane : largest;
#pragma GCC unroll 1
    for (; x < cells; ++x) {
        const double here = hn::GetLane(function(one, x));
        largest = here > largest ? here : largest;
    }
    return largest;
}

/// As for_each_vector, but calls loop(d, x, several) for groups of vectors, as many as the constant
/// `several` says: `group`, and one where no more are left.
template <std::size_t group, class Loop>
HWY_INLINE void for_each_group(int count, const Loop& loop) {
    const hn::ScalableTag<double> doubles;
    constexpr std::size_t cells = group * hn::MaxLanes(doubles);
    constexpr std::integral_constant<std::size_t, group> several;
    constexpr std::integral_constant<std::size_t, 1> one;
    const std::size_t grouped = static_cast<std::size_t>(count) / cells * cells;
    for (std::size_t x = 0; x < grouped; x += cells) loop(doubles, x, several);
    for_each_vector(count - static_cast<int>(grouped),
                    [&](auto d, std::size_t x) HWY_ATTR { loop(d, grouped + x, one); });
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
