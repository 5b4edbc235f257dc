#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/pixel_class_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/samples/pixel_class_vectors.h"
#include "render/samples/rasteriser_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::pixel_class_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Words = hn::Rebind<std::uint32_t, Floats>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using Number = hn::Vec<Floats>;

/// What samples in one corner of each pixel see.
struct SurfacePoint {
    Number x;  // offset from the eye
    Number y;
    Number z;
    Number range;
    Number length;  // see visibility_vectors::record_rows()
    hn::Vec<Words> kind;
};

/// From the samples' numbers and lengths.
HWY_INLINE SurfacePoint surface_point(hn::Vec<Words> number, hn::Vec<Words> length,
                                      const Rays& rays, Number column) {
    const Floats d;
    const Words words;
    const auto one = hn::Set(d, 1.0F);
    const auto low = hn::Set(words, rasteriser_vectors::kind_bits);
    const auto reversed_z = hn::BitCast(d, hn::AndNot(low, number));
    const auto visible = hn::Gt(reversed_z, hn::Zero(d));
    const auto depth = hn::IfThenElseZero(visible, one / hn::IfThenElse(visible, reversed_z, one));
    const auto offset = [&](int axis) HWY_ATTR {
        return (hn::Set(d, rays.first[axis]) + column * hn::Set(d, rays.right[axis])) * depth;
    };
    const auto x = offset(0);
    const auto y = offset(1);
    const auto z = offset(2);
    return {x, y, z, hn::Sqrt(x * x + y * y + z * z), hn::BitCast(d, length), hn::And(low, number)};
}

/// What is known of samples in the corners of pixels: south-western ones, south-eastern,
/// north-western and north-eastern ones.
struct CornerValues {
    hn::Vec<Words> sw;
    hn::Vec<Words> se;
    hn::Vec<Words> nw;
    hn::Vec<Words> ne;
};

/// Of pixels in those columns; `apart`: from their numbers to what is wanted.
HWY_INLINE CornerValues gather_corners(const CornerSamples& corners, hn::Vec<Integers> pixel,
                                       std::ptrdiff_t apart) {
    const Words words;
    const Integers integers;
    const auto first = hn::Set(integers, std::int32_t{corners.first}) +
                       hn::Set(integers, std::int32_t{corners.factor}) * pixel;
    const auto last = first + hn::Set(integers, std::int32_t{corners.factor - 1});
    const auto look_up = [&](const std::uint32_t* row, hn::Vec<Integers> column) HWY_ATTR {
        const auto one = hn::Set(integers, 1);
        const auto at = hn::ShiftLeft<1>(hn::AndNot(one, column)) + hn::And(column, one);
        return hn::GatherIndex(words, row + apart, at);
    };
    return {look_up(corners.lower, first), look_up(corners.lower, last),
            look_up(corners.upper, first), look_up(corners.upper, last)};
}

/// The same where a pixel has these together, of as many pixels as a vector has from the `first`.
HWY_INLINE CornerValues load_corners(const CornerSamples& corners, std::size_t first,
                                     std::ptrdiff_t apart) {
    const Words words;
    CornerValues known;
    hn::LoadInterleaved4(words, corners.lower + apart + 2 * corners.first + 4 * first, known.sw,
                         known.se, known.nw, known.ne);
    return known;
}

/// Whether tongues may be at places from the eye.
HWY_INLINE hn::Mask<Words> may_have_slid(const ClassBounds& bounds, Number x, Number y) {
    const Floats d;
    const Words words;
    const Integers integers;
    const AvalancheMap& slid = bounds.slid;
    const auto tiles = [&](Number at, float eye, float extent) HWY_ATTR {
        return (hn::Set(d, eye) + at) / hn::Set(d, extent) + hn::Set(d, 0.5F);
    };
    const auto tiles_east = tiles(x, slid.east, bounds.extent_x);
    const auto tiles_north = tiles(y, slid.north, bounds.extent_y);
    const auto whole_east = hn::Floor(tiles_east);
    const auto whole_north = hn::Floor(tiles_north);
    auto east = tiles_east - whole_east;
    const auto north = tiles_north - whole_north;
    if (slid.plain) {
        const auto own = hn::And(hn::Eq(whole_east, hn::Zero(d)), hn::Eq(whole_north, hn::Zero(d)));
        east = hn::Set(d, 0.5F) * (east + hn::IfThenElse(own, hn::Zero(d), hn::Set(d, 1.0F)));
    }
    const auto cell = [&](Number share, int cells) HWY_ATTR {
        const auto at = hn::ConvertTo(integers, share * hn::Set(d, static_cast<float>(cells)));
        return hn::Min(at, hn::Set(integers, std::int32_t{cells - 1}));
    };
    const auto column = cell(east, slid.nx);
    const auto row = cell(north, slid.ny);
    const auto word = hn::GatherIndex(
        words, slid.words,
        row * hn::Set(integers, std::int32_t{slid.words_per_row}) + hn::ShiftRight<5>(column));
    const auto bit =
        hn::Shl(hn::Set(words, 1U), hn::BitCast(words, hn::And(column, hn::Set(integers, 31))));
    return hn::Ne(hn::And(word, bit), hn::Zero(words));
}

void classify_row(const CornerSamples& corners, const ClassBounds& bounds, std::size_t count,
                  std::uint32_t* kinds) {
    const Floats d;
    const Words words;
    const Integers integers;
    const auto number = [&](float value) HWY_ATTR { return hn::Set(d, value); };
    const auto whole_number = [&](std::uint32_t value) HWY_ATTR { return hn::Set(words, value); };
    const auto factor = static_cast<float>(corners.factor);
    const auto between = static_cast<float>(corners.factor - 1);
    const auto last = static_cast<std::int32_t>(count) - 1;
    const auto squared = [](Number a, Number b) HWY_ATTR { return a * a + b * b; };
    std::uint32_t found[HWY_MAX_BYTES / sizeof(std::uint32_t)];
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto pixel =
            hn::Min(hn::Iota(integers, static_cast<std::int32_t>(i)), hn::Set(integers, last));
        const bool together = corners.factor == 2 && i + hn::Lanes(d) <= count;
        const auto look_up = [&](std::ptrdiff_t apart) HWY_ATTR {
            return together ? load_corners(corners, i, apart)
                            : gather_corners(corners, pixel, apart);
        };
        const CornerValues numbers = look_up(0);
        const CornerValues lengths = look_up(corners.lengths);
        const auto column = number(corners.first_column) + number(factor) * hn::ConvertTo(d, pixel);
        const auto last_column = column + number(between);
        const SurfacePoint sw = surface_point(numbers.sw, lengths.sw, corners.lower_rays, column);
        const SurfacePoint se =
            surface_point(numbers.se, lengths.se, corners.lower_rays, last_column);
        const SurfacePoint nw = surface_point(numbers.nw, lengths.nw, corners.upper_rays, column);
        const SurfacePoint ne =
            surface_point(numbers.ne, lengths.ne, corners.upper_rays, last_column);

        // Where one sees other ground the nearest and the farthest of them are farther apart than
        // the slope that they lie on makes them.
        const auto least = hn::Min(hn::Min(sw.range, se.range), hn::Min(nw.range, ne.range));
        const auto most = hn::Max(hn::Max(sw.range, se.range), hn::Max(nw.range, ne.range));
        const auto slant =
            hn::Min(hn::Min(sw.length, se.length), hn::Min(nw.length, ne.length)) * number(factor);
        const auto whole =
            hn::And(hn::Gt(least, hn::Zero(d)),
                    hn::Le(most - least, number(1.5F) * slant + number(0.002F) * least));

        const auto quarter = number(0.25F);
        const auto x = quarter * (sw.x + se.x + nw.x + ne.x);
        const auto y = quarter * (sw.y + se.y + nw.y + ne.y);
        const auto z = quarter * (sw.z + se.z + nw.z + ne.z);
        const auto pixels = number(0.5F * factor / between);  // half of one, over the corners' way
        const auto along_x = pixels * (se.x - sw.x + ne.x - nw.x);
        const auto along_y = pixels * (se.y - sw.y + ne.y - nw.y);
        const auto along_z = pixels * (se.z - sw.z + ne.z - nw.z);
        const auto up_x = pixels * (nw.x - sw.x + ne.x - se.x);
        const auto up_y = pixels * (nw.y - sw.y + ne.y - se.y);
        const auto up_z = pixels * (nw.z - sw.z + ne.z - se.z);

        const auto is_far =
            hn::Ge(squared(x, y) + z * z, number(bounds.near_limit * bounds.near_limit));
        // One look at the bed's maps does for a pixel of less than a texel, which is of no copy.
        const auto across = hn::Max(squared(along_x, along_y), squared(up_x, up_y));
        auto plain = hn::Lt(across * number(bounds.texels * bounds.texels), number(1.0F));
        if (bounds.varied) {
            constexpr float unwarped_radius_periods = 0.7F;  // of shaders/world/tile_warp.glsl
            const auto from_middle = squared(number(bounds.east) + x / number(bounds.extent_x),
                                             number(bounds.north) + y / number(bounds.extent_y));
            plain = hn::And(plain, hn::Lt(from_middle, number(unwarped_radius_periods *
                                                              unwarped_radius_periods)));
        }
        const auto normal_x = along_y * up_z - along_z * up_y;
        const auto normal_y = along_z * up_x - along_x * up_z;
        const auto normal_z = along_x * up_y - along_y * up_x;
        const auto is_steep =
            hn::Gt(squared(normal_x, normal_y),
                   number(bounds.steepest_smooth_slope * bounds.steepest_smooth_slope) * normal_z *
                       normal_z);

        auto has_tongues = hn::RebindMask(words, is_steep);
        if (bounds.slid.words != nullptr && !hn::AllFalse(words, has_tongues))
            has_tongues = hn::And(has_tongues, may_have_slid(bounds, x, y));
        const auto plain_kind =
            hn::IfThenElse(has_tongues, whole_number(slid), whole_number(smooth));
        const auto near_kind =
            hn::IfThenElse(hn::RebindMask(words, plain), plain_kind, whole_number(near));
        const auto whole_kind =
            hn::IfThenElse(hn::RebindMask(words, is_far), whole_number(far), near_kind);
        const auto samples = hn::Or(hn::Or(sw.kind, se.kind), hn::Or(nw.kind, ne.kind));
        const auto kind = hn::IfThenElse(hn::RebindMask(words, whole), whole_kind, samples);
        if (i + hn::Lanes(d) <= count) {
            hn::StoreU(kind, words, kinds + i);
        } else {
            hn::StoreU(kind, words, found);
            std::copy_n(found, count - i, kinds + i);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::pixel_class_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::pixel_class_vectors {

HWY_EXPORT(classify_row);

void classify_row(const CornerSamples& corners, const ClassBounds& bounds, std::size_t count,
                  std::uint32_t* kinds) {
    HWY_DYNAMIC_DISPATCH(classify_row)(corners, bounds, count, kinds);
}

}  // namespace fumon::pixel_class_vectors
#endif
