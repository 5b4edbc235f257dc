#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/g_buffer_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>

#include "render/samples/block_rays-inl.h"
#include "render/samples/g_buffer_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::g_buffer_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace rays = block_vectors::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using Words = hn::Rebind<std::uint32_t, Floats>;
using Real = hn::Vec<Floats>;
using Word = hn::Vec<Words>;

constexpr int samples = MultiSurfacePixels::samples;

/// Of the bed, under places; `apart`: cells between samples.
HWY_INLINE Word kind_at(const KindMap& map, Real east, Real north, Real apart) {
    const Floats d;
    const Integers integers;
    const auto cell_of = [&](const KindMap::Level& level) HWY_ATTR {
        const auto along = [&](Real position, int count) HWY_ATTR {
            const auto at =
                hn::ConvertTo(integers, position * hn::Set(d, static_cast<float>(count)));
            return hn::Min(at, hn::Set(integers, std::int32_t{count} - 1));
        };
        return hn::Set(integers, std::int32_t{level.first}) + along(east, level.width) +
               along(north, level.height) * hn::Set(integers, std::int32_t{level.width});
    };
    auto cell = cell_of(map.levels[0]);
    for (std::size_t i = 1; i < map.levels.size(); ++i) {
        const auto coarse = hn::RebindMask(integers, hn::Ge(apart, hn::Set(d, map.bounds[i - 1])));
        if (!hn::AllFalse(integers, coarse))
            cell = hn::IfThenElse(coarse, cell_of(map.levels[i]), cell);
    }
    const auto* bytes = reinterpret_cast<const std::int32_t*>(map.kinds.data());
    return hn::And(hn::BitCast(Words(), hn::GatherOffset(integers, bytes, cell)),
                   hn::Set(Words(), 255U));
}

/// Pixels of a vector, from `first` on, that are listed.
HWY_INLINE void list(Word is_listed, std::size_t first, std::size_t pixels,
                     const Real positions[3][samples], Word kinds, Word apart,
                     MultiSurfacePixels& listed) {
    const Floats d;
    const Words words;
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(float);
    HWY_ALIGN std::uint32_t chosen[most];
    HWY_ALIGN std::uint32_t of[most];
    HWY_ALIGN std::uint32_t two[most];
    HWY_ALIGN float at[3][samples][most];
    hn::Store(is_listed, words, chosen);
    hn::Store(kinds, words, of);
    hn::Store(apart, words, two);
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < samples; ++k) hn::Store(positions[axis][k], d, at[axis][k]);
    const std::size_t end = std::min(hn::Lanes(d), pixels - first);
    for (std::size_t i = 0; i < end; ++i) {
        if (chosen[i] == 0) continue;
        const std::size_t next = listed.count++;
        listed.pixel[next] = static_cast<std::int32_t>(first + i);
        listed.kinds[next] = of[i];
        listed.are_apart[next] = two[i];
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k < samples; ++k) listed.positions[axis][k][next] = at[axis][k][i];
    }
}

void resolve_positions(const Row& row, const SplitRules& rules, float* positions,
                       std::uint8_t* kinds, std::uint8_t* state, MultiSurfacePixels& listed) {
    using block_vectors::mixed;
    using block_vectors::surface_kind;
    using block_vectors::surface_only;
    const Floats d;
    const Integers integers;
    const Words words;
    const hn::Rebind<std::uint8_t, Floats> bytes;
    const std::size_t lanes = hn::Lanes(d);
    const block_vectors::PixelRow& of = row.pixels;
    const auto pixels = static_cast<std::size_t>(of.pixels);
    const auto put = [&](std::uint8_t* out, Word values) HWY_ATTR {
        hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(integers, values)), bytes, out);
    };
    listed.count = 0;
    for (std::size_t x = 0; x < pixels; x += lanes) {
        Word sample[samples];
        hn::LoadInterleaved2(words, of.lower + 2 * x, sample[0], sample[1]);
        hn::LoadInterleaved2(words, of.upper + 2 * x, sample[2], sample[3]);
        const auto low = hn::Set(words, rasteriser_vectors::kind_bits);
        const auto surface = hn::Set(words, surface_kind);
        Word kind[samples];
        for (int k = 0; k < samples; ++k) kind[k] = hn::And(sample[k], low);
        const auto alike = hn::And(hn::And(hn::Eq(kind[0], kind[1]), hn::Eq(kind[0], kind[2])),
                                   hn::Eq(kind[0], kind[3]));
        const auto all_surface = hn::And(alike, hn::Eq(kind[0], surface));
        auto some_surface = hn::Eq(kind[0], surface);
        for (int k = 1; k < samples; ++k)
            some_surface = hn::Or(some_surface, hn::Eq(kind[k], surface));
        auto becomes = hn::IfThenElse(alike, kind[0], hn::Set(words, std::uint32_t{mixed}));
        becomes = hn::IfThenElse(all_surface, hn::Set(words, std::uint32_t{surface_only}), becomes);
        put(state + x, becomes);
        if (hn::AllFalse(words, some_surface) && hn::AllTrue(words, alike)) {
            hn::StoreU(hn::Zero(bytes), bytes, kinds + x);
            continue;
        }
        const auto column = rays::columns_from(of.first_column, x);
        const auto none = hn::Zero(d);
        Real at[3][samples];
        Real sum[3] = {none, none, none};
        Real least[2] = {hn::Set(d, 2.0F), hn::Set(d, 2.0F)};
        Real most[2] = {hn::Set(d, -1.0F), hn::Set(d, -1.0F)};
        auto counted = none;
        for (int k = 0; k < samples; ++k) {
            const auto sees = hn::RebindMask(d, hn::Eq(kind[k], surface));
            const auto depth = rays::depth_of(of.depths, sample[k]);
            const auto middle = k % 2 == 0 ? column : column + hn::Set(d, 1.0F);
            const block_vectors::Rays along[3] = {of.east[k / 2], of.north[k / 2],
                                                  row.height[k / 2]};
            counted = counted + hn::IfThenElseZero(sees, hn::Set(d, 1.0F));
            for (int axis = 0; axis < 3; ++axis) {
                const auto position =
                    hn::IfThenElseZero(sees, rays::position_at(along[axis], middle, depth));
                at[axis][k] = position;
                sum[axis] = sum[axis] + position;
                if (axis == 2) continue;
                least[axis] = hn::IfThenElse(sees, hn::Min(least[axis], position), least[axis]);
                most[axis] = hn::IfThenElse(sees, hn::Max(most[axis], position), most[axis]);
            }
        }
        const auto share = hn::Set(d, 1.0F) / hn::Max(counted, hn::Set(d, 1.0F));
        Real mean[3];
        auto squared = none;
        for (int axis = 0; axis < 3; ++axis) {
            mean[axis] = sum[axis] * share;
            const auto way =
                hn::Set(d, rules.low[axis]) + mean[axis] * hn::Set(d, rules.size[axis]);
            squared = squared + way * way;
        }
        const auto range = [&](int axis) HWY_ATTR {
            return (most[axis] - least[axis]) * hn::Set(d, rules.cells[axis]);
        };
        const auto apart = hn::Max(hn::Max(range(0), range(1)), none);
        const auto width = hn::Set(d, rules.pixel_width) *
                           (rules.perspective ? hn::Sqrt(squared) : hn::Set(d, 1.0F));
        const auto cell_length = hn::Set(d, rules.size[0] / rules.cells[0]);
        const auto far_apart =
            hn::And(hn::Gt(apart, hn::Set(d, rules.split_distance_cells)),
                    hn::Gt(apart * cell_length, hn::Set(d, rules.split_distance_pixels) * width));
        const auto visible = hn::RebindMask(d, some_surface);
        put(kinds + x,
            hn::IfThenElseZero(some_surface, kind_at(*rules.map, mean[0], mean[1], apart)));
        hn::StoreInterleaved4(mean[0], mean[1], mean[2], apart, d, positions + 4 * x);
        const auto two = hn::RebindMask(words, hn::And(far_apart, visible));
        const auto is_listed = hn::Or(two, hn::Not(alike));
        if (hn::AllFalse(words, is_listed)) continue;
        const auto all_kinds =
            hn::Or(hn::Or(kind[0], hn::ShiftLeft<8>(kind[1])),
                   hn::Or(hn::ShiftLeft<16>(kind[2]), hn::ShiftLeft<24>(kind[3])));
        const auto one = hn::Set(words, 1U);
        list(hn::IfThenElseZero(is_listed, one), x, pixels, at, all_kinds,
             hn::IfThenElseZero(two, one), listed);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::g_buffer_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::g_buffer_vectors {

HWY_EXPORT(resolve_positions);

void MultiSurfacePixels::allocate(int pixels) {
    const std::size_t capacity =
        static_cast<std::size_t>(pixels) + rasteriser_vectors::Band::beyond;
    if (pixel.size() >= capacity) return;
    pixel.resize(capacity);
    kinds.resize(capacity);
    are_apart.resize(capacity);
    for (auto& axis : positions)
        for (std::vector<float>& of : axis) of.resize(capacity);
}

void resolve_positions(const Row& row, const SplitRules& rules, float* positions,
                       std::uint8_t* kinds, std::uint8_t* state, MultiSurfacePixels& listed) {
    HWY_DYNAMIC_DISPATCH(resolve_positions)(row, rules, positions, kinds, state, listed);
}

}  // namespace fumon::g_buffer_vectors
#endif
