#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/pixel_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/samples/pixel_vectors.h"
#include "render/samples/triangle_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::pixel_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Words = hn::Rebind<std::uint32_t, Floats>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using Number = hn::Vec<Floats>;

/// What samples in one corner of each pixel see.
struct Seen {
    Number x;  // offset from the eye
    Number y;
    Number z;
    Number range;
    Number length;  // see seen_vectors::lengths_of_row()
    hn::Vec<Words> kind;
};

HWY_INLINE Seen seen_at(const std::uint32_t* samples, hn::Vec<Integers> at, const Rays& rays,
                        Number column) {
    const Floats d;
    const Words words;
    const auto one = hn::Set(d, 1.0F);
    const auto number = hn::GatherIndex(words, samples, at);
    const auto low = hn::Set(words, triangle_vectors::kind_bits);
    const auto nearness = hn::BitCast(d, hn::AndNot(low, number));
    const auto seen = hn::Gt(nearness, hn::Zero(d));
    const auto depth = hn::IfThenElseZero(seen, one / hn::IfThenElse(seen, nearness, one));
    const auto offset = [&](int axis) HWY_ATTR {
        return (hn::Set(d, rays.first[axis]) + column * hn::Set(d, rays.right[axis])) * depth;
    };
    const auto x = offset(0);
    const auto y = offset(1);
    const auto z = offset(2);
    const auto length = hn::BitCast(d, hn::GatherIndex(words, samples + 1, at));
    return {x, y, z, hn::Sqrt(x * x + y * y + z * z), length, hn::And(low, number)};
}

void kinds_of_row(const Corners& corners, const Bounds& bounds, std::size_t count,
                  std::uint32_t* kinds) {
    const Floats d;
    const Words words;
    const Integers integers;
    const auto number = [&](float value) HWY_ATTR { return hn::Set(d, value); };
    const auto whole_number = [&](std::uint32_t value) HWY_ATTR { return hn::Set(words, value); };
    const auto factor = static_cast<float>(corners.factor);
    const auto between = static_cast<float>(corners.factor - 1);
    const auto apart = hn::Set(integers, std::int32_t{2 * (corners.factor - 1)});
    const auto last = static_cast<std::int32_t>(count) - 1;
    const auto squared = [](Number a, Number b) HWY_ATTR { return a * a + b * b; };
    std::uint32_t found[HWY_MAX_BYTES / sizeof(std::uint32_t)];
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto pixel =
            hn::Min(hn::Iota(integers, static_cast<std::int32_t>(i)), hn::Set(integers, last));
        const auto at = hn::Set(integers, std::int32_t{2 * corners.factor}) * pixel;
        const auto column = number(corners.first_column) + number(factor) * hn::ConvertTo(d, pixel);
        const auto last_column = column + number(between);
        const Seen sw = seen_at(corners.lower, at, corners.lower_rays, column);
        const Seen se = seen_at(corners.lower, at + apart, corners.lower_rays, last_column);
        const Seen nw = seen_at(corners.upper, at, corners.upper_rays, column);
        const Seen ne = seen_at(corners.upper, at + apart, corners.upper_rays, last_column);

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

        const auto is_far = hn::Ge(squared(x, y) + z * z, number(bounds.near_to * bounds.near_to));
        // One look at the bed's maps does for a pixel of less than a texel, which is of no copy.
        const auto across = hn::Max(squared(along_x, along_y), squared(up_x, up_y));
        auto plain = hn::Lt(across * number(bounds.texels * bounds.texels), number(1.0F));
        if (bounds.varied) {
            constexpr float as_it_is = 0.7F;  // of shaders/world/far_copies.glsl
            const auto from_middle = squared(number(bounds.east) + x / number(bounds.extent_x),
                                             number(bounds.north) + y / number(bounds.extent_y));
            plain = hn::And(plain, hn::Lt(from_middle, number(as_it_is * as_it_is)));
        }
        const auto normal_x = along_y * up_z - along_z * up_y;
        const auto normal_y = along_z * up_x - along_x * up_z;
        const auto normal_z = along_x * up_y - along_y * up_x;
        const auto is_steep =
            hn::Gt(squared(normal_x, normal_y),
                   number(bounds.level_fall * bounds.level_fall) * normal_z * normal_z);

        const auto plain_kind = hn::IfThenElse(hn::RebindMask(words, is_steep), whole_number(steep),
                                               whole_number(level));
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
}  // namespace fumon::pixel_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::pixel_vectors {

HWY_EXPORT(kinds_of_row);

void kinds_of_row(const Corners& corners, const Bounds& bounds, std::size_t count,
                  std::uint32_t* kinds) {
    HWY_DYNAMIC_DISPATCH(kinds_of_row)(corners, bounds, count, kinds);
}

}  // namespace fumon::pixel_vectors
#endif
