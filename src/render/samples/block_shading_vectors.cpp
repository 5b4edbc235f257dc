#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/block_shading_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/colour/grain.h"
#include "render/samples/block_rays-inl.h"
#include "render/samples/block_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::block_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using Words = hn::Rebind<std::uint32_t, Floats>;
using Real = hn::Vec<Floats>;
using Whole = hn::Vec<Integers>;
using Word = hn::Vec<Words>;

/// Two neighbouring texels along one axis, and how far a place lies from the first to the second.
struct LinearTaps {
    Whole first;
    Whole second;
    Real share;
};

HWY_INLINE LinearTaps linear_taps(Real position, int count) {
    const Floats d;
    const Integers integers;
    const auto at = position * hn::Set(d, static_cast<float>(count)) - hn::Set(d, 0.5F);
    const auto cell = hn::Floor(at);
    const auto last = hn::Set(integers, std::int32_t{count} - 1);
    const auto first = hn::ConvertTo(integers, cell);
    return {hn::Max(first, hn::Zero(integers)),
            hn::Min(first + hn::Set(integers, std::int32_t{1}), last), at - cell};
}

HWY_INLINE Real byte_of(Word packed, int position) {
    const Words words;
    const Integers integers;
    const auto byte = hn::And(hn::ShiftRightSame(packed, 8 * position), hn::Set(words, 255U));
    return hn::ConvertTo(Floats(), hn::BitCast(integers, byte));
}

/// The grain less its middle, −0.5 … 0.5, of a level.
HWY_INLINE Real sample_grain(const SurfaceTexture& surface, Real east, Real north, Whole level) {
    const Floats d;
    const Integers integers;
    const auto one = hn::Set(integers, std::int32_t{1});
    // 2^−level by its exponent.
    const auto halved =
        hn::BitCast(d, hn::ShiftLeft<23>(hn::Set(integers, std::int32_t{127}) - level));
    const auto half = hn::Set(d, 0.5F);
    const auto u = east * hn::Set(d, surface.grain_east) * halved - half;
    const auto v = north * hn::Set(d, surface.grain_north) * halved - half;
    const auto whole_u = hn::Floor(u);
    const auto whole_v = hn::Floor(v);
    const auto size = hn::Shr(hn::Set(integers, std::int32_t{grain_size}), level);
    const auto x = hn::And(hn::ConvertTo(integers, whole_u), size - one);
    const auto y = hn::And(hn::ConvertTo(integers, whole_v), size - one);
    // The texels of finer levels, which come first.
    constexpr std::int32_t finest = grain_size * grain_size;
    const auto before = [&](std::int32_t of_level, std::int32_t texels) HWY_ATTR {
        return hn::IfThenElseZero(hn::Gt(level, hn::Set(integers, of_level - 1)),
                                  hn::Set(integers, texels));
    };
    const auto first = before(1, finest) + before(2, finest / 4) + before(3, finest / 16);
    const auto four = hn::BitCast(
        Words(), hn::GatherIndex(integers, reinterpret_cast<const std::int32_t*>(surface.grain),
                                 first + y * size + x));
    const auto share_u = u - whole_u;
    const auto south = byte_of(four, 0) + share_u * (byte_of(four, 1) - byte_of(four, 0));
    const auto next = byte_of(four, 2) + share_u * (byte_of(four, 3) - byte_of(four, 2));
    const auto level_byte = south + (v - whole_v) * (next - south);
    return level_byte * hn::Set(d, 1.0F / 255.0F) - half;
}

/// Display values, 0 … 255, rounded.
struct Colour {
    Whole red;
    Whole green;
    Whole blue;
};

/// A look at the surface; `level` of the grain.
HWY_INLINE Colour sample_surface(const SurfaceTexture& surface, Real east, Real north,
                                 Whole level) {
    const Floats d;
    const Integers integers;
    const LinearTaps x = linear_taps(east, surface.width);
    const LinearTaps y = linear_taps(north, surface.height);
    const auto* texels = reinterpret_cast<const std::int32_t*>(surface.texels);
    const auto width = hn::Set(integers, std::int32_t{surface.width});
    const auto lower = y.first * width;
    const auto upper = y.second * width;
    const auto texel = [&](Whole at) HWY_ATTR {
        return hn::BitCast(Words(), hn::GatherIndex(integers, texels, at));
    };
    const auto south_west = texel(lower + x.first);
    const auto south_east = texel(lower + x.second);
    const auto north_west = texel(upper + x.first);
    const auto north_east = texel(upper + x.second);
    const auto channel = [&](int position) HWY_ATTR {
        const auto west = byte_of(south_west, position);
        const auto above = byte_of(north_west, position);
        const auto south = west + x.share * (byte_of(south_east, position) - west);
        const auto next = above + x.share * (byte_of(north_east, position) - above);
        return south + y.share * (next - south);
    };
    auto factor = hn::Set(d, 1.0F);
    if (surface.grain != nullptr) {
        const auto grain = channel(3) * hn::Set(d, surface.strength * (1.0F / 255.0F));
        factor = factor + grain * sample_grain(surface, east, north, level);
    }
    const auto rounded = [&](int position) HWY_ATTR {
        const auto value = hn::Min(channel(position) * factor, hn::Set(d, 255.0F));
        return hn::ConvertTo(integers, hn::Max(value, hn::Zero(d)) + hn::Set(d, 0.5F));
    };
    return {rounded(0), rounded(1), rounded(2)};
}

/// The grain's level for texels that lie this far apart, squared: the first three bounds passed.
HWY_INLINE Whole mip_level(Real squared, float first_bound) {
    const Floats d;
    const Integers integers;
    const auto one = hn::Set(integers, std::int32_t{1});
    const auto passed = [&](float bound) HWY_ATTR {
        return hn::IfThenElseZero(hn::RebindMask(integers, hn::Ge(squared, hn::Set(d, bound))),
                                  one);
    };
    return passed(first_bound) + passed(4.0F * first_bound) + passed(16.0F * first_bound);
}

HWY_INLINE Real larger(Real a, Real b) {
    return hn::Max(hn::Abs(a), hn::Abs(b));
}

/// Sums of squares of the samples of listed pixels that see the surface.
void shade_edge_pixels(const SurfaceTexture& surface, EdgePixels& edges) {
    // A level is the nearest to the binary logarithm of how far samples lie apart.
    constexpr float first_bound = 2.0F;
    const Floats d;
    const Integers integers;
    const Words words;
    const auto scale_east = hn::Set(d, surface.grain_east);
    const auto scale_north = hn::Set(d, surface.grain_north);
    for (std::size_t i = 0; i < edges.count; i += hn::Lanes(d)) {
        Real east[EdgePixels::samples];
        Real north[EdgePixels::samples];
        for (int k = 0; k < EdgePixels::samples; ++k) {
            east[k] = hn::LoadU(d, edges.east[k].data() + i);
            north[k] = hn::LoadU(d, edges.north[k].data() + i);
        }
        const auto apart = [&](int from, int to) HWY_ATTR {
            const auto u = (east[to] - east[from]) * scale_east;
            const auto v = (north[to] - north[from]) * scale_north;
            return u * u + v * v;
        };
        const auto level =
            mip_level(hn::Max(hn::Min(apart(0, 1), apart(2, 3)), hn::Min(apart(0, 2), apart(1, 3))),
                      first_bound);
        const auto kinds = hn::LoadU(words, edges.kinds.data() + i);
        Whole red = hn::Zero(integers);
        Whole green = red;
        Whole blue = red;
        for (int k = 0; k < EdgePixels::samples; ++k) {
            const auto kind = hn::And(hn::ShiftRightSame(kinds, 8 * k), hn::Set(words, 255U));
            const auto sees = hn::RebindMask(integers, hn::Eq(kind, hn::Set(words, surface_kind)));
            const Colour shaded = sample_surface(surface, east[k], north[k], level);
            red = red + hn::IfThenElseZero(sees, shaded.red * shaded.red);
            green = green + hn::IfThenElseZero(sees, shaded.green * shaded.green);
            blue = blue + hn::IfThenElseZero(sees, shaded.blue * shaded.blue);
        }
        hn::StoreU(hn::BitCast(words, red), words, edges.sums[0].data() + i);
        hn::StoreU(hn::BitCast(words, green), words, edges.sums[1].data() + i);
        hn::StoreU(hn::BitCast(words, blue), words, edges.sums[2].data() + i);
    }
}

HWY_INLINE void list_edge_pixels(hn::Mask<Floats> listed, std::size_t first, std::size_t pixels,
                                 const Real* east, const Real* north, Word kinds,
                                 EdgePixels& edges) {
    const Floats d;
    const Words words;
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(float);
    HWY_ALIGN std::uint32_t is_listed[most];
    hn::Store(hn::IfThenElseZero(hn::RebindMask(words, listed), hn::Set(words, 1U)), words,
              is_listed);
    HWY_ALIGN float positions[2 * EdgePixels::samples][most];
    HWY_ALIGN std::uint32_t of[most];
    for (std::size_t k = 0; k < EdgePixels::samples; ++k) {
        hn::Store(east[k], d, positions[2 * k]);
        hn::Store(north[k], d, positions[2 * k + 1]);
    }
    hn::Store(kinds, words, of);
    const std::size_t end = std::min(hn::Lanes(d), pixels - first);
    for (std::size_t i = 0; i < end; ++i) {
        if (is_listed[i] == 0) continue;
        const std::size_t at = edges.count++;
        edges.pixel[at] = static_cast<std::int32_t>(first + i);
        edges.kinds[at] = of[i];
        for (std::size_t k = 0; k < EdgePixels::samples; ++k) {
            edges.east[k][at] = positions[2 * k][i];
            edges.north[k][at] = positions[2 * k + 1][i];
        }
    }
}

void shade_row(const PixelRow& row, const SurfaceTexture& surface, const PixelPlanes& planes,
               EdgePixels& edges) {
    // Between samples, in texels: up to there a look halfway between them misses nothing.
    constexpr float single_lookup_texels = 1.25F;
    // Of the grain's levels, with a bias of −0.4: ground lies aslant, and the finer axis should not
    // be blurred as much as the other one. 2^1.8, for differences of two samples a pixel.
    constexpr float first_bound = 3.4822023F / 4.0F;
    const Floats d;
    const Integers integers;
    const Words words;
    const hn::Rebind<std::uint8_t, Floats> bytes;
    const std::size_t lanes = hn::Lanes(d);
    const auto pixels = static_cast<std::size_t>(row.pixels);
    edges.count = 0;
    for (std::size_t x = 0; x < pixels; x += lanes) {
        Word sample[EdgePixels::samples];
        hn::LoadInterleaved2(words, row.lower + 2 * x, sample[0], sample[1]);
        hn::LoadInterleaved2(words, row.upper + 2 * x, sample[2], sample[3]);
        const auto any = hn::Or(hn::Or(sample[0], sample[1]), hn::Or(sample[2], sample[3]));
        if (hn::AllTrue(words, hn::Eq(any, hn::Zero(words)))) {
            hn::StoreU(hn::Zero(bytes), bytes, planes.state + x);
            continue;
        }
        const auto low = hn::Set(words, rasteriser_vectors::kind_bits);
        Word kind[EdgePixels::samples];
        for (int k = 0; k < EdgePixels::samples; ++k) kind[k] = hn::And(sample[k], low);
        const auto alike = hn::And(hn::And(hn::Eq(kind[0], kind[1]), hn::Eq(kind[0], kind[2])),
                                   hn::Eq(kind[0], kind[3]));
        const auto is_surface = hn::Set(words, surface_kind);
        const auto all_surface = hn::And(alike, hn::Eq(kind[0], is_surface));
        auto some_surface = hn::Eq(kind[0], is_surface);
        for (int k = 1; k < EdgePixels::samples; ++k)
            some_surface = hn::Or(some_surface, hn::Eq(kind[k], is_surface));
        auto state = hn::IfThenElse(alike, kind[0], hn::Set(words, std::uint32_t{mixed}));
        state = hn::IfThenElse(all_surface, hn::Set(words, std::uint32_t{surface_only}), state);
        hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(integers, state)), bytes, planes.state + x);
        const bool sides_alone = hn::AllFalse(words, some_surface) && hn::AllTrue(words, alike);
        if (sides_alone) continue;

        Real east[EdgePixels::samples];
        Real north[EdgePixels::samples];
        const auto column = columns_from(row.first_column, x);
        for (int k = 0; k < EdgePixels::samples; ++k) {
            const auto depth = depth_of(row.depths, sample[k]);
            const auto at = k % 2 == 0 ? column : column + hn::Set(d, 1.0F);
            east[k] = position_at(row.east[k / 2], at, depth);
            north[k] = position_at(row.north[k / 2], at, depth);
        }
        const auto range = [&](const Real* position, int texels) HWY_ATTR {
            const auto least =
                hn::Min(hn::Min(position[0], position[1]), hn::Min(position[2], position[3]));
            const auto most =
                hn::Max(hn::Max(position[0], position[1]), hn::Max(position[2], position[3]));
            return (most - least) * hn::Set(d, static_cast<float>(texels));
        };
        const auto close = hn::Le(hn::Max(range(east, surface.width), range(north, surface.height)),
                                  hn::Set(d, single_lookup_texels));
        const auto whole = hn::And(hn::RebindMask(d, all_surface), close);
        if (!hn::AllFalse(d, whole)) {
            const auto quarter = hn::Set(d, 0.25F);
            const auto mean = [&](const Real* position) HWY_ATTR {
                return ((position[0] + position[1]) + (position[2] + position[3])) * quarter;
            };
            const auto by_east = hn::Set(d, surface.grain_east);
            const auto by_north = hn::Set(d, surface.grain_north);
            const auto apart = hn::Max(larger(east[1] - east[0], east[2] - east[0]) * by_east,
                                       larger(north[1] - north[0], north[2] - north[0]) * by_north);
            const Colour shaded = sample_surface(surface, mean(east), mean(north),
                                                 mip_level(apart * apart, first_bound));
            hn::StoreU(hn::DemoteTo(bytes, shaded.red), bytes, planes.red + x);
            hn::StoreU(hn::DemoteTo(bytes, shaded.green), bytes, planes.green + x);
            hn::StoreU(hn::DemoteTo(bytes, shaded.blue), bytes, planes.blue + x);
        }
        const auto is_mixed = hn::RebindMask(d, hn::Not(alike));
        const auto listed = hn::Or(is_mixed, hn::AndNot(whole, hn::RebindMask(d, all_surface)));
        if (hn::AllFalse(d, listed)) continue;
        const auto kinds = hn::Or(hn::Or(kind[0], hn::ShiftLeft<8>(kind[1])),
                                  hn::Or(hn::ShiftLeft<16>(kind[2]), hn::ShiftLeft<24>(kind[3])));
        list_edge_pixels(listed, x, pixels, east, north, kinds, edges);
    }
    shade_edge_pixels(surface, edges);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::block_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::block_vectors {

HWY_EXPORT(shade_row);

void EdgePixels::allocate(int pixels) {
    const std::size_t capacity =
        static_cast<std::size_t>(pixels) + rasteriser_vectors::Band::beyond;
    if (pixel.size() >= capacity) return;
    pixel.resize(capacity);
    kinds.resize(capacity);
    for (std::vector<float>& positions : east) positions.resize(capacity);
    for (std::vector<float>& positions : north) positions.resize(capacity);
    for (std::vector<std::uint32_t>& of : sums) of.resize(capacity);
}

void shade_row(const PixelRow& row, const SurfaceTexture& surface, const PixelPlanes& planes,
               EdgePixels& edges) {
    HWY_DYNAMIC_DISPATCH(shade_row)(row, surface, planes, edges);
}

std::vector<std::uint32_t> packed_grain() {
    std::vector<std::uint32_t> packed;
    std::vector<std::uint8_t> texels = grain_texels();
    constexpr int coarsest_mip_level = 3;
    for (int level = 0; level <= coarsest_mip_level; ++level) {
        const auto size = static_cast<std::size_t>(grain_size >> level);
        for (std::size_t y = 0; y < size; ++y) {
            const std::uint8_t* here = texels.data() + y * size;
            const std::uint8_t* next = texels.data() + (y + 1) % size * size;
            for (std::size_t x = 0; x < size; ++x) {
                const std::size_t east = (x + 1) % size;
                packed.push_back(here[x] | std::uint32_t{here[east]} << 8U |
                                 std::uint32_t{next[x]} << 16U | std::uint32_t{next[east]} << 24U);
            }
        }
        if (level < coarsest_mip_level) texels = downsampled_texels(texels, static_cast<int>(size));
    }
    return packed;
}

}  // namespace fumon::block_vectors
#endif
