#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/block_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/samples/block_vectors.h"
#include "render/samples/triangle_clipping.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::block_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;

/// x, y and reversed z of as many corners as a vector of doubles has.
HWY_INLINE void project_lanes(const VertexProjection& projection, const float* positions,
                              const float* heights, std::int32_t* x, std::int32_t* y,
                              float* reversed_z) {
    const Doubles d;
    const hn::Rebind<float, Doubles> floats;
    const hn::Rebind<std::int32_t, Doubles> integers;
    hn::Vec<decltype(floats)> read_east;
    hn::Vec<decltype(floats)> read_north;
    hn::LoadInterleaved2(floats, positions, read_east, read_north);
    const auto east = hn::PromoteTo(d, read_east);
    const auto north = hn::PromoteTo(d, read_north);
    const auto height = hn::PromoteTo(d, hn::LoadU(floats, heights));
    const auto value = [&](const AffineFunction& of) HWY_ATTR {
        return hn::Set(d, of.east) * east + hn::Set(d, of.north) * north +
               hn::Set(d, of.height) * height + hn::Set(d, of.constant);
    };
    const auto depth = value(projection.depth);
    const auto least = hn::Set(d, projection.least_depth);
    const auto before = hn::Ge(depth, least);
    const auto safe = hn::IfThenElse(before, depth, least);
    const auto half = hn::Set(d, 0.5);
    const auto at_x = hn::Floor(value(projection.x) / safe + half);
    const auto at_y = hn::Floor(value(projection.y) / safe + half);
    const auto farthest = hn::Set(d, guard_band);
    const auto inside = hn::And(hn::Le(hn::Abs(at_x), farthest), hn::Le(hn::Abs(at_y), farthest));
    const auto in_guard_band = hn::And(before, inside);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(in_guard_band, at_x)), integers, x);
    hn::StoreU(hn::DemoteTo(integers, hn::IfThenElseZero(in_guard_band, at_y)), integers, y);
    hn::StoreU(hn::DemoteTo(floats,
                            hn::IfThenElseZero(in_guard_band, value(projection.reversed_z) / safe)),
               floats, reversed_z);
}

void project_vertices(const VertexProjection& projection, const float* positions,
                      const float* heights, std::size_t count, std::int32_t* x, std::int32_t* y,
                      float* reversed_z) {
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
    const std::size_t lanes = hn::Lanes(Doubles());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        project_lanes(projection, positions + 2 * i, heights + i, x + i, y + i, reversed_z + i);
    if (i == count) return;
    float last_positions[2 * most] = {};
    float last_heights[most] = {};
    std::int32_t last_x[most];
    std::int32_t last_y[most];
    float last_reversed_z[most];
    std::copy(positions + 2 * i, positions + 2 * count, last_positions);
    std::copy(heights + i, heights + count, last_heights);
    project_lanes(projection, last_positions, last_heights, last_x, last_y, last_reversed_z);
    for (std::size_t k = 0; i < count; ++i, ++k) {
        x[i] = last_x[k];
        y[i] = last_y[k];
        reversed_z[i] = last_reversed_z[k];
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::block_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::block_vectors {

HWY_EXPORT(project_vertices);

void project_vertices(const VertexProjection& projection, const float* positions,
                      const float* heights, std::size_t count,
                      rasteriser_vectors::ProjectedVertices& vertices, std::size_t first) {
    HWY_DYNAMIC_DISPATCH(project_vertices)
    (projection, positions, heights, count, vertices.x.data() + first, vertices.y.data() + first,
     vertices.reversed_z.data() + first);
}

}  // namespace fumon::block_vectors
#endif
