#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/visibility_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/samples/triangle_clipping.h"
#include "render/samples/visibility_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::visibility_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Floats = hn::ScalableTag<float>;
using Words = hn::Rebind<std::uint32_t, Floats>;

/// x, y and reversed z of as many corners as a vector of doubles has.
HWY_INLINE void project_lanes(const Perspective& projection, const float* offsets, std::int32_t* x,
                              std::int32_t* y, float* reversed_z) {
    const Doubles d;
    const hn::Rebind<float, Doubles> floats;
    const hn::Rebind<std::int32_t, Doubles> integers;
    hn::Vec<decltype(floats)> read[3];
    hn::LoadInterleaved3(floats, offsets, read[0], read[1], read[2]);
    const auto east = hn::PromoteTo(d, read[0]);
    const auto north = hn::PromoteTo(d, read[1]);
    const auto height = hn::PromoteTo(d, read[2]);
    const auto value = [&](const LinearForm& of) HWY_ATTR {
        return hn::Set(d, of.x) * east + hn::Set(d, of.y) * north + hn::Set(d, of.z) * height;
    };
    const auto depth = value(projection.depth);
    const auto near = hn::Set(d, projection.near_depth);
    const auto before = hn::Ge(depth, near);
    const auto safe = hn::IfThenElse(before, depth, near);
    const auto half = hn::Set(d, 0.5);
    const auto at_x = hn::Floor(value(projection.x) / safe + half);
    const auto at_y = hn::Floor(value(projection.y) / safe + half);
    const auto farthest = hn::Set(d, guard_band);
    const auto inside = hn::And(hn::Le(hn::Abs(at_x), farthest), hn::Le(hn::Abs(at_y), farthest));
    const auto in_guard_band = hn::And(before, inside);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(in_guard_band, at_x)), integers, x);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(in_guard_band, at_y)), integers, y);
    hn::StoreU(hn::DemoteTo(floats, hn::IfThenElseZero(in_guard_band, near / safe)), floats,
               reversed_z);
}

void project_vertices(const Perspective& projection, const float* offsets, std::size_t count,
                      std::int32_t* x, std::int32_t* y, float* reversed_z) {
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
    const std::size_t lanes = hn::Lanes(Doubles());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        project_lanes(projection, offsets + 3 * i, x + i, y + i, reversed_z + i);
    if (i == count) return;
    float last_offsets[3 * most] = {};
    std::int32_t last_x[most];
    std::int32_t last_y[most];
    float last_reversed_z[most];
    std::copy(offsets + 3 * i, offsets + 3 * count, last_offsets);
    project_lanes(projection, last_offsets, last_x, last_y, last_reversed_z);
    for (std::size_t k = 0; i < count; ++i, ++k) {
        x[i] = last_x[k];
        y[i] = last_y[k];
        reversed_z[i] = last_reversed_z[k];
    }
}

/// Of as many samples of a row as a vector has, from the `first` one on.
HWY_INLINE hn::Vec<Words> lengths_of(const VisibilityRow& row, float first_column,
                                     std::size_t first, hn::Vec<Words> sample) {
    const Floats d;
    const Words words;
    const HorizontalRays& rays = row.rays;
    const auto slope = hn::LoadU(words, row.slopes + first);
    const auto right_x = hn::Set(d, rays.right_x);
    const auto right_y = hn::Set(d, rays.right_y);
    const auto column = hn::Iota(d, first_column + static_cast<float>(first));
    const auto x = hn::Set(d, rays.first_x) + column * right_x;
    const auto y = hn::Set(d, rays.first_y) + column * right_y;
    const auto level = hn::Max(hn::Sqrt(x * x + y * y), hn::Set(d, 1e-30F));
    const auto low = hn::Set(words, rasteriser_vectors::kind_bits);
    const auto reversed_z = hn::BitCast(d, hn::AndNot(low, sample));
    const auto visible = hn::Gt(reversed_z, hn::Zero(d));
    const auto depth = hn::Set(d, 1.0F) / hn::IfThenElse(visible, reversed_z, hn::Set(d, 1.0F));
    const auto upper = hn::Set(words, 0xFFFF0000U);
    const auto by_right = hn::BitCast(d, hn::And(slope, upper)) * depth * level;
    const auto by_up = hn::BitCast(d, hn::ShiftLeft<16>(slope)) * depth * level;
    const auto rightward = (right_x * x + right_y * y) / level - by_right;
    const auto upward = (hn::Set(d, rays.up_x) * x + hn::Set(d, rays.up_y) * y) / level - by_up;
    const auto length = (hn::Abs(rightward) + hn::Abs(upward)) * depth;
    return hn::BitCast(words, hn::IfThenElseZero(visible, length));
}

/// Stores numbers of samples from the `first` one of two rows on, by fours.
HWY_INLINE void store_quads(hn::Vec<Words> lower, hn::Vec<Words> upper, std::size_t first,
                            std::uint32_t* out) {
    if constexpr (hn::MaxLanes(Words()) == 1) {
        std::uint32_t* at = out + 4 * (first / 2) + first % 2;
        at[0] = hn::GetLane(lower);
        at[2] = hn::GetLane(upper);
    }
#if HWY_TARGET != HWY_SCALAR  // which has single numbers alone
    else {
        const hn::Repartition<std::uint64_t, Words> pairs;
        hn::StoreInterleaved2(hn::BitCast(pairs, lower), hn::BitCast(pairs, upper), pairs,
                              reinterpret_cast<std::uint64_t*>(out + 2 * first));
    }
#endif
}

void record_rows(const VisibilityRow& lower, const VisibilityRow& upper, float first_column,
                 std::size_t count, std::uint32_t* numbers, std::uint32_t* lengths) {
    const Words words;
    for (std::size_t i = 0; i < count; i += hn::Lanes(words)) {
        const auto below = hn::LoadU(words, lower.samples + i);
        const auto above = hn::LoadU(words, upper.samples + i);
        store_quads(below, above, i, numbers);
        store_quads(lengths_of(lower, first_column, i, below),
                    lengths_of(upper, first_column, i, above), i, lengths);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::visibility_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::visibility_vectors {

HWY_EXPORT(project_vertices);
HWY_EXPORT(record_rows);

void project_vertices(const Perspective& projection, const float* offsets, std::size_t count,
                      rasteriser_vectors::ProjectedVertices& vertices, std::size_t first) {
    HWY_DYNAMIC_DISPATCH(project_vertices)
    (projection, offsets, count, vertices.x.data() + first, vertices.y.data() + first,
     vertices.reversed_z.data() + first);
}

void record_rows(const VisibilityRow& lower, const VisibilityRow& upper, float first_column,
                 std::size_t count, std::uint32_t* numbers, std::uint32_t* lengths) {
    HWY_DYNAMIC_DISPATCH(record_rows)(lower, upper, first_column, count, numbers, lengths);
}

}  // namespace fumon::visibility_vectors
#endif
