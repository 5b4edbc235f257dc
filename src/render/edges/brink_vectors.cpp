#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/edges/brink_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "render/edges/brink_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::brink_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The values of cells and of the next ones.
template <class V>
struct Neighbours {
    V first;
    V second;
};

template <class D>
HWY_INLINE Neighbours<hn::Vec<D>> look_up(D d, const std::uint64_t* pairs,
                                          hn::Vec<hn::Rebind<std::int32_t, D>> cells) {
    if constexpr (hn::MaxLanes(D()) == 1) {
        const std::uint64_t pair = pairs[hn::GetLane(cells)];
        return {hn::Set(d, std::bit_cast<float>(static_cast<std::uint32_t>(pair))),
                hn::Set(d, std::bit_cast<float>(static_cast<std::uint32_t>(pair >> 32U)))};
    }
#if HWY_TARGET != HWY_SCALAR  // which has single numbers alone
    else {
        const hn::Repartition<std::uint64_t, D> whole;
        const hn::Repartition<std::int64_t, D> wide;
        const hn::Half<hn::Rebind<std::int32_t, D>> half;
        const auto lower = hn::BitCast(
            d, hn::GatherIndex(whole, pairs, hn::PromoteTo(wide, hn::LowerHalf(half, cells))));
        const auto upper = hn::BitCast(
            d, hn::GatherIndex(whole, pairs, hn::PromoteTo(wide, hn::UpperHalf(half, cells))));
        return {hn::ConcatEven(d, upper, lower), hn::ConcatOdd(d, upper, lower)};
    }
#endif
}

/// Cells from `x` on, as many as a vector of the tag has.
template <class D>
HWY_INLINE void mix_means(D d, const Heights& field, int y, const RowOfEdges& edges, float step,
                          int x, float* heights) {
    const auto zero = hn::Zero(d);
    const auto on_edge = hn::Ne(hn::LoadU(d, edges.share + x), zero);
    if (hn::AllFalse(d, on_edge)) return;
    const hn::Rebind<std::int32_t, D> integers;
    const auto columns = hn::Set(integers, std::int32_t{field.nx});
    const auto east = hn::LoadU(d, edges.east + x);
    const auto north = hn::LoadU(d, edges.north + x);
    const auto cell_x = hn::Iota(d, static_cast<float>(x));
    const auto cell_y = hn::Set(d, static_cast<float>(y));
    auto sum = zero;
    float weights = 0.0F;
#pragma GCC unroll 1
    for (int i = -positions_aside; i <= positions_aside; ++i) {
        const auto away = hn::Set(d, step * static_cast<float>(i));
        const auto within = [&](auto position, int count) HWY_ATTR {
            return hn::Min(hn::Max(position, zero), hn::Set(d, static_cast<float>(count - 1)));
        };
        const auto u = within(cell_x + away * east, field.nx);
        const auto v = within(cell_y + away * north, field.ny);
        const auto west =
            hn::Min(hn::ConvertTo(integers, u), hn::Set(integers, std::int32_t{field.nx} - 2));
        const auto south =
            hn::Min(hn::ConvertTo(integers, v), hn::Set(integers, std::int32_t{field.ny} - 2));
        const auto right = u - hn::ConvertTo(d, west);
        const auto upper = v - hn::ConvertTo(d, south);
        const auto first = south * columns + west;
        const auto between = [&](auto at) HWY_ATTR {
            const auto cells = look_up(d, field.pairs, at);
            return cells.first + right * (cells.second - cells.first);
        };
        const auto low = between(first);
        const auto high = between(first + columns);
        const auto weight = static_cast<float>(positions_aside + 1 - std::abs(i));
        sum = sum + hn::Set(d, weight) * (low + upper * (high - low));
        weights += weight;
    }
    const auto before = hn::LoadU(d, heights + x);
    const auto mixed =
        before + hn::LoadU(d, edges.share + x) * (sum / hn::Set(d, weights) - before);
    hn::StoreU(hn::IfThenElse(on_edge, mixed, before), d, heights + x);
}

void mix_means_along(const Heights& field, int y, const RowOfEdges& edges, float step,
                     float* heights) {
    const hn::ScalableTag<float> d;
    const hn::CappedTag<float, 1> last;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    int x = 0;
    for (; x + lanes <= field.nx; x += lanes) mix_means(d, field, y, edges, step, x, heights);
#pragma GCC unroll 1
    for (; x < field.nx; ++x) mix_means(last, field, y, edges, step, x, heights);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::brink_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::brink_vectors {

HWY_EXPORT(mix_means_along);

std::vector<std::uint64_t, HugePageAllocator<std::uint64_t>> pairs_of(const float* values,
                                                                      int count) {
    std::vector<std::uint64_t, HugePageAllocator<std::uint64_t>> pairs;
    pairs.reserve(static_cast<std::size_t>(count));
    std::uint64_t own = std::bit_cast<std::uint32_t>(values[0]);
    for (int i = 1; i < count; ++i) {
        const std::uint64_t next = std::bit_cast<std::uint32_t>(values[i]);
        pairs.push_back(own | next << 32U);
        own = next;
    }
    pairs.push_back(own);
    return pairs;
}

void mix_means_along(const Heights& field, int y, const RowOfEdges& edges, float step,
                     float* heights) {
    HWY_DYNAMIC_DISPATCH(mix_means_along)(field, y, edges, step, heights);
}

}  // namespace fumon::brink_vectors
#endif
