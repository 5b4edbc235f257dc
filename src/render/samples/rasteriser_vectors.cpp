#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/rasteriser_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "render/samples/rasteriser_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::rasteriser_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using Words = hn::Rebind<std::uint32_t, Floats>;
using Whole = hn::Vec<Integers>;

/// A triangle, counter-clockwise, and the reversed_z over it.
struct TriangleSetup {
    std::int32_t x[3];
    std::int32_t y[3];
    std::int32_t left;  // columns and rows of samples that may lie in it
    std::int32_t right;
    std::int32_t bottom;
    std::int32_t top;
    float first;  // at the first corner
    float by_x;   // for 1/256 of a sample
    float by_y;
    float least;
    float most;
    std::uint32_t slopes;  ///< see Band
};

/// Whether samples on an edge that goes this way belong to what lies on its left: of two ways, one.
HWY_INLINE bool owns_edge(std::int64_t dx, std::int64_t dy) {
    return dy > 0 || (dy == 0 && dx > 0);
}

/// Two numbers, each by the upper half of its bits, rounded.
HWY_INLINE std::uint32_t pack_slopes(float upper, float lower) {
    constexpr std::uint32_t half = 0x8000U;
    return ((std::bit_cast<std::uint32_t>(upper) + half) & 0xFFFF0000U) |
           ((std::bit_cast<std::uint32_t>(lower) + half) >> 16U);
}

/// The nearer of what a band has and a triangle, of samples that lie in it. `slopes`: of the
/// samples.
template <bool with_slopes>
HWY_INLINE void write_nearest(hn::Mask<Words> inside, const TriangleSetup& t, float row,
                              std::int32_t x, std::uint32_t kind, std::uint32_t* samples,
                              std::uint32_t* slopes) {
    const Floats d;
    const Words words;
    const Integers integers;
    const auto steps = hn::Set(integers, x - t.x[0]) + hn::ShiftLeft<8>(hn::Iota(integers, 0));
    const auto plane = hn::Set(d, row) + hn::Set(d, t.by_x) * hn::ConvertTo(d, steps);
    const auto reversed_z = hn::Max(hn::Min(plane, hn::Set(d, t.most)), hn::Set(d, t.least));
    const auto bits = hn::AndNot(hn::Set(words, kind_bits), hn::BitCast(words, reversed_z));
    const auto sample = hn::IfThenElseZero(inside, hn::Or(bits, hn::Set(words, kind)));
    const auto before = hn::LoadU(words, samples);
    hn::StoreU(hn::Max(before, sample), words, samples);
    if constexpr (with_slopes)
        hn::BlendedStore(hn::Set(words, t.slopes), hn::Gt(sample, before), words, slopes);
}

HWY_INLINE float reversed_z_of_row(const TriangleSetup& t, std::int32_t y) {
    return t.first + t.by_y * static_cast<float>(y - t.y[0]);
}

constexpr std::int32_t sample_centre = 128;  // of a sample, which is 256 wide

template <bool with_slopes>
HWY_INLINE void rasterise_small(const TriangleSetup& t, std::uint32_t kind, const Band& band) {
    const Integers d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const std::int32_t x = 256 * t.left + sample_centre;
    const std::int32_t y = 256 * t.bottom + sample_centre;
    std::int32_t at[3];
    std::int32_t by_row[3];
    Whole by_column[3];
    for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        const std::int32_t dx = t.x[next] - t.x[k];
        const std::int32_t dy = t.y[next] - t.y[k];
        at[k] = dx * (y - t.y[k]) - dy * (x - t.x[k]) - (owns_edge(dx, dy) ? 0 : 1);
        by_row[k] = 256 * dx;
        by_column[k] = hn::Set(d, -256 * dy) * hn::Iota(d, 0);
    }
    for (std::int32_t row = t.bottom; row <= t.top; ++row) {
        const std::size_t start = static_cast<std::size_t>(row - band.first_row) * band.stride;
        const float reversed_z = reversed_z_of_row(t, 256 * row + sample_centre);
        for (std::int32_t column = t.left; column <= t.right; column += lanes) {
            const std::int32_t aside = column - t.left;
            Whole edges = hn::Zero(d);
            for (int k = 0; k < 3; ++k) {
                const int next = k == 2 ? 0 : k + 1;
                const std::int32_t dy = t.y[next] - t.y[k];
                edges = hn::Or(edges, hn::Set(d, at[k] - 256 * dy * aside) + by_column[k]);
            }
            const std::size_t at_sample =
                start + static_cast<std::size_t>(column - band.first_column);
            write_nearest<with_slopes>(hn::RebindMask(Words(), hn::Gt(edges, hn::Set(d, -1))), t,
                                       reversed_z, 256 * column + sample_centre, kind,
                                       band.samples + at_sample,
                                       with_slopes ? band.slopes + at_sample : nullptr);
        }
        for (int k = 0; k < 3; ++k) at[k] += by_row[k];
    }
}

/// The largest whole number not above a / b, b > 0.
HWY_INLINE std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

/// Of any size: row by row, from where to where it reaches.
template <bool with_slopes>
HWY_INLINE void rasterise_large(const TriangleSetup& t, std::uint32_t kind, const Band& band) {
    const Words words;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(words));
    for (std::int32_t row = t.bottom; row <= t.top; ++row) {
        const std::int64_t y = 256 * std::int64_t{row} + sample_centre;
        std::int64_t left = t.left;
        std::int64_t right = t.right;
        for (int k = 0; k < 3; ++k) {
            const int next = k == 2 ? 0 : k + 1;
            const std::int64_t dx = std::int64_t{t.x[next]} - t.x[k];
            const std::int64_t dy = std::int64_t{t.y[next]} - t.y[k];
            // At the first column's middle, of which each next one takes 256 · dy.
            const std::int64_t first =
                dx * (y - t.y[k]) - dy * (sample_centre - t.x[k]) - (owns_edge(dx, dy) ? 0 : 1);
            if (dy > 0) {
                right = std::min(right, floor_divide(first, 256 * dy));
            } else if (dy < 0) {
                left = std::max(left, -floor_divide(first, -256 * dy));
            } else if (first < 0) {
                right = left - 1;
            }
        }
        const std::size_t start = static_cast<std::size_t>(row - band.first_row) * band.stride;
        const float reversed_z = reversed_z_of_row(t, static_cast<std::int32_t>(y));
        for (std::int64_t column = left; column <= right; column += lanes) {
            const auto count = static_cast<std::size_t>(std::min(lanes, right - column + 1));
            const std::size_t at_sample =
                start + static_cast<std::size_t>(column - band.first_column);
            write_nearest<with_slopes>(hn::FirstN(words, count), t, reversed_z,
                                       static_cast<std::int32_t>(256 * column + sample_centre),
                                       kind, band.samples + at_sample,
                                       with_slopes ? band.slopes + at_sample : nullptr);
        }
    }
}

template <bool with_slopes>
HWY_INLINE void rasterise_listed(const ProjectedVertices& vertices, const Triangles& triangles,
                                 const Band& band) {
    constexpr std::int32_t small = 90 * 256;  // up to which edges are numbers of 32 bits
    for (std::size_t i = 0; i < triangles.count; ++i) {
        const std::uint32_t* of = triangles.indices + std::size_t{3} * triangles.listed[i];
        const std::size_t a = triangles.first_vertex + of[0];
        std::size_t b = triangles.first_vertex + of[1];
        std::size_t c = triangles.first_vertex + of[2];
        TriangleSetup t;
        const auto [left, right] = std::minmax({vertices.x[a], vertices.x[b], vertices.x[c]});
        const auto [low, high] = std::minmax({vertices.y[a], vertices.y[b], vertices.y[c]});
        t.left = std::max((left + sample_centre - 1) >> 8, band.first_column);
        t.right = std::min((right - sample_centre) >> 8, band.end_column - 1);
        t.bottom = std::max((low + sample_centre - 1) >> 8, band.first_row);
        t.top = std::min((high - sample_centre) >> 8, band.end_row - 1);
        if (t.left > t.right || t.bottom > t.top) continue;
        const auto twice_area = [&] {
            return (std::int64_t{vertices.x[b]} - vertices.x[a]) *
                       (std::int64_t{vertices.y[c]} - vertices.y[a]) -
                   (std::int64_t{vertices.y[b]} - vertices.y[a]) *
                       (std::int64_t{vertices.x[c]} - vertices.x[a]);
        };
        std::int64_t area = twice_area();
        if (area == 0 || (area < 0 && !triangles.double_sided)) continue;
        if (area < 0) {
            std::swap(b, c);
            area = -area;
        }
        t.x[0] = vertices.x[a];
        t.x[1] = vertices.x[b];
        t.x[2] = vertices.x[c];
        t.y[0] = vertices.y[a];
        t.y[1] = vertices.y[b];
        t.y[2] = vertices.y[c];
        const float first = vertices.reversed_z[a];
        const float second = vertices.reversed_z[b];
        const float third = vertices.reversed_z[c];
        const float share = 1.0F / static_cast<float>(area);
        const auto length = [](std::int32_t from, std::int32_t to) {
            return static_cast<float>(to - from);
        };
        t.first = first;
        t.by_x =
            ((second - first) * length(t.y[0], t.y[2]) - (third - first) * length(t.y[0], t.y[1])) *
            share;
        t.by_y =
            ((third - first) * length(t.x[0], t.x[1]) - (second - first) * length(t.x[0], t.x[2])) *
            share;
        if constexpr (with_slopes) t.slopes = pack_slopes(256.0F * t.by_x, 256.0F * t.by_y);
        t.least = std::min({first, second, third});
        t.most = std::max({first, second, third});
        if (right - left <= small && high - low <= small) {
            rasterise_small<with_slopes>(t, triangles.kind, band);
        } else {
            rasterise_large<with_slopes>(t, triangles.kind, band);
        }
    }
}

void rasterise(const ProjectedVertices& vertices, const Triangles& triangles, const Band& band) {
    if (band.slopes == nullptr) {
        rasterise_listed<false>(vertices, triangles, band);
    } else {
        rasterise_listed<true>(vertices, triangles, band);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::rasteriser_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::rasteriser_vectors {

HWY_EXPORT(rasterise);

void ProjectedVertices::resize(std::size_t count) {
    x.resize(count);
    y.resize(count);
    reversed_z.resize(count);
}

void rasterise(const ProjectedVertices& vertices, const Triangles& triangles, const Band& band) {
    HWY_DYNAMIC_DISPATCH(rasterise)(vertices, triangles, band);
}

}  // namespace fumon::rasteriser_vectors
#endif
