#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "picture/pixels/level_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "picture/pixels/level_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::level_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Levels = hn::ScalableTag<std::uint8_t>;
using Level = hn::Vec<Levels>;

/// How many pixels of a row go by whole vectors.
HWY_INLINE int in_vectors(int pixels) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    (void)pixels;
    return 0;  // plain loops are faster than vectors of single numbers
#else
    constexpr auto lanes = static_cast<int>(hn::MaxLanes(Levels()));
    return pixels - pixels % lanes;
#endif
}

HWY_INLINE Level apart(Level a, Level b) {
    return hn::Or(hn::SaturatedSub(a, b), hn::SaturatedSub(b, a));
}

/// The differences of the levels of a vector of pixels.
struct Differences {
    Level red;
    Level green;
    Level blue;
    [[nodiscard]] HWY_INLINE Level largest() const { return hn::Max(red, hn::Max(green, blue)); }
};

/// The levels of a vector of pixels.
struct Pixels {
    Level red;
    Level green;
    Level blue;
};

HWY_INLINE Pixels pixels_at(const std::uint8_t* levels) {
    Pixels pixels{hn::Undefined(Levels()), hn::Undefined(Levels()), hn::Undefined(Levels())};
    hn::LoadInterleaved3(Levels(), levels, pixels.red, pixels.green, pixels.blue);
    return pixels;
}

HWY_INLINE Differences differences(const Pixels& a, const Pixels& b) {
    return {apart(a.red, b.red), apart(a.green, b.green), apart(a.blue, b.blue)};
}

#if HWY_TARGET != HWY_SCALAR  // which has single numbers alone

using Words = hn::ScalableTag<std::uint16_t>;
using HalfLevels = hn::Half<Levels>;

/// 256 times the luminance of half a vector of pixels.
HWY_INLINE hn::Vec<Words> luminance(hn::Vec<HalfLevels> red, hn::Vec<HalfLevels> green,
                                    hn::Vec<HalfLevels> blue) {
    const Words words;
    const auto times = [&](hn::Vec<HalfLevels> level, std::uint16_t factor) HWY_ATTR {
        return hn::PromoteTo(words, level) * hn::Set(words, factor);
    };
    return times(red, 77) + times(green, 150) + times(blue, 29);
}

HWY_INLINE hn::Vec<Words> lower_luminance(const Pixels& of) {
    return luminance(hn::LowerHalf(HalfLevels(), of.red), hn::LowerHalf(HalfLevels(), of.green),
                     hn::LowerHalf(HalfLevels(), of.blue));
}

HWY_INLINE hn::Vec<Words> upper_luminance(const Pixels& of) {
    return luminance(hn::UpperHalf(HalfLevels(), of.red), hn::UpperHalf(HalfLevels(), of.green),
                     hn::UpperHalf(HalfLevels(), of.blue));
}

#endif

RowDifference row_difference(const std::uint8_t* first, const std::uint8_t* second, int pixels) {
    RowDifference row;
    const int whole = in_vectors(pixels);
#if HWY_TARGET != HWY_SCALAR
    constexpr Levels levels;
    constexpr hn::ScalableTag<std::uint64_t> longs;
    constexpr std::size_t lanes = hn::MaxLanes(levels);
    auto largest = hn::Zero(levels);
    auto sum = hn::Zero(longs);
    std::size_t same = 0;
    for (int x = 0; x < whole; x += static_cast<int>(lanes)) {
        const std::ptrdiff_t at = std::ptrdiff_t{3} * x;
        const Differences by = differences(pixels_at(first + at), pixels_at(second + at));
        const Level most = by.largest();
        largest = hn::Max(largest, most);
        same += hn::CountTrue(levels, most == hn::Zero(levels));
        sum = sum + hn::SumsOf8(by.red) + hn::SumsOf8(by.green) + hn::SumsOf8(by.blue);
    }
    HWY_ALIGN std::uint8_t each_largest[lanes];
    HWY_ALIGN std::uint64_t each_sum[hn::MaxLanes(longs)];
    hn::Store(largest, levels, each_largest);
    hn::Store(sum, longs, each_sum);
    for (const std::uint8_t one : each_largest) row.largest = std::max(row.largest, int{one});
    for (const std::uint64_t one : each_sum) row.sum += static_cast<std::int64_t>(one);
    row.changed = whole - static_cast<int>(same);
#endif
    for (int x = whole; x < pixels; ++x) {
        const std::uint8_t* a = first + std::ptrdiff_t{3} * x;
        const std::uint8_t* b = second + std::ptrdiff_t{3} * x;
        const int red = std::abs(a[0] - b[0]);
        const int green = std::abs(a[1] - b[1]);
        const int blue = std::abs(a[2] - b[2]);
        row.largest = std::max({row.largest, red, green, blue});
        row.changed += static_cast<int>((red | green | blue) != 0);
        row.sum += red + green + blue;
    }
    return row;
}

void mark_row(const std::uint8_t* first, const std::uint8_t* second, int pixels,
              std::uint8_t* out) {
    constexpr int dark = 120;   // red of a difference of one level, nearly: seen at once
    constexpr int yellow = 64;  // levels from which on red turns to yellow
    const int whole = in_vectors(pixels);
#if HWY_TARGET != HWY_SCALAR
    constexpr Levels levels;
    constexpr std::size_t lanes = hn::MaxLanes(levels);
    const auto half_grey = [&](hn::Vec<Words> luminance) HWY_ATTR {
        return hn::DemoteTo(
            HalfLevels(), hn::BitCast(hn::RebindToSigned<Words>(), hn::ShiftRight<10>(luminance)));
    };
    for (int x = 0; x < whole; x += static_cast<int>(lanes)) {
        const std::ptrdiff_t at = std::ptrdiff_t{3} * x;
        const Pixels a = pixels_at(first + at);
        const Level by = differences(a, pixels_at(second + at)).largest();
        const auto same = by == hn::Zero(levels);
        const Level grey =
            hn::Combine(levels, half_grey(upper_luminance(a)), half_grey(lower_luminance(a)));
        const Level twice = hn::SaturatedAdd(by, by);
        const Level red =
            hn::SaturatedAdd(hn::SaturatedAdd(twice, twice), hn::Set(levels, std::uint8_t{dark}));
        const Level over = hn::SaturatedSub(by, hn::Set(levels, std::uint8_t{yellow}));
        const Level green = hn::SaturatedAdd(over, over);
        hn::StoreInterleaved3(hn::IfThenElse(same, grey, red), hn::IfThenElse(same, grey, green),
                              hn::IfThenElseZero(same, grey), levels, out + at);
    }
#endif
    for (int x = whole; x < pixels; ++x) {
        const std::uint8_t* a = first + std::ptrdiff_t{3} * x;
        const std::uint8_t* b = second + std::ptrdiff_t{3} * x;
        std::uint8_t* to = out + std::ptrdiff_t{3} * x;
        const int by =
            std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
        if (by == 0) {
            const int grey = (77 * a[0] + 150 * a[1] + 29 * a[2]) >> 10;  // a quarter
            std::fill_n(to, 3, static_cast<std::uint8_t>(grey));
            continue;
        }
        to[0] = static_cast<std::uint8_t>(std::min(255, dark + 4 * by));
        to[1] = static_cast<std::uint8_t>(std::clamp(2 * (by - yellow), 0, 255));
        to[2] = 0;
    }
}

void luminance_row(const std::uint8_t* levels, int pixels, std::int16_t* out) {
    const int whole = in_vectors(pixels);
#if HWY_TARGET != HWY_SCALAR
    constexpr Words words;
    constexpr hn::RebindToSigned<Words> integers;
    constexpr std::size_t lanes = hn::MaxLanes(words);
    const auto middle = hn::Set(words, static_cast<std::uint16_t>(middle_luminance));
    for (int x = 0; x < whole; x += 2 * static_cast<int>(lanes)) {
        const Pixels pixels_here = pixels_at(levels + std::ptrdiff_t{3} * x);
        hn::StoreU(hn::BitCast(integers, lower_luminance(pixels_here) - middle), integers, out + x);
        hn::StoreU(hn::BitCast(integers, upper_luminance(pixels_here) - middle), integers,
                   out + x + lanes);
    }
#endif
    for (int x = whole; x < pixels; ++x) {
        const std::uint8_t* pixel = levels + std::ptrdiff_t{3} * x;
        out[x] = static_cast<std::int16_t>(77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2] -
                                           middle_luminance);
    }
}

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

void tile_sums(const std::int16_t* a, const std::int16_t* b, std::size_t stride, int rows,
               int tiles, TileSums* out) {
    for (int tile = 0; tile < tiles; ++tile) {
        TileSums sums;
        for (int row = 0; row < rows; ++row) {
            const std::size_t at =
                static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(tile) * tile_side;
            for (std::size_t i = at; i < at + tile_side; ++i) {
                const std::int64_t left = a[i];
                const std::int64_t right = b[i];
                sums.a += left;
                sums.b += right;
                sums.aa += left * left;
                sums.bb += right * right;
                sums.ab += left * right;
            }
        }
        out[tile] = sums;
    }
}

#else

using Row = hn::FixedTag<std::int16_t, tile_side>;
using Pairs = hn::Repartition<std::int32_t, Row>;

/// A row's products, those of two neighbours added: at most 2 · 32640², less than 2^31.
HWY_INLINE hn::Vec<Pairs> products(hn::Vec<Row> a, hn::Vec<Row> b) {
    auto others = hn::Zero(Pairs());
    const auto some = hn::ReorderWidenMulAccumulate(Pairs(), a, b, hn::Zero(Pairs()), others);
    return some + others;
}

/// A sum of products that 32 bits do not hold: those above the lower 16 bits, and these.
struct LongSum {
    hn::Vec<Pairs> high;
    hn::Vec<Pairs> low;

    HWY_INLINE void add(hn::Vec<Pairs> value) {
        high = high + hn::ShiftRight<16>(value);
        low = low + hn::And(value, hn::Set(Pairs(), std::int32_t{0xFFFF}));
    }
    [[nodiscard]] HWY_INLINE std::int64_t total() const {
        const std::int64_t upper = hn::GetLane(hn::SumOfLanes(Pairs(), high));
        const std::int64_t lower = hn::GetLane(hn::SumOfLanes(Pairs(), low));
        return upper * 65536 + lower;
    }
};

void tile_sums(const std::int16_t* a, const std::int16_t* b, std::size_t stride, int rows,
               int tiles, TileSums* out) {
    const auto ones = hn::Set(Row(), std::int16_t{1});
    const auto none = hn::Zero(Pairs());
    for (int tile = 0; tile < tiles; ++tile) {
        auto sum_a = none;
        auto sum_b = none;
        LongSum aa{none, none};
        LongSum bb{none, none};
        LongSum ab{none, none};
        for (int row = 0; row < rows; ++row) {
            const std::size_t at =
                static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(tile) * tile_side;
            const auto left = hn::LoadU(Row(), a + at);
            const auto right = hn::LoadU(Row(), b + at);
            sum_a = sum_a + products(left, ones);
            sum_b = sum_b + products(right, ones);
            aa.add(products(left, left));
            bb.add(products(right, right));
            ab.add(products(left, right));
        }
        out[tile] = {hn::GetLane(hn::SumOfLanes(Pairs(), sum_a)),
                     hn::GetLane(hn::SumOfLanes(Pairs(), sum_b)), aa.total(), bb.total(),
                     ab.total()};
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace fumon::level_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::level_vectors {

HWY_EXPORT(row_difference);
HWY_EXPORT(mark_row);
HWY_EXPORT(luminance_row);
HWY_EXPORT(tile_sums);

RowDifference row_difference(const std::uint8_t* first, const std::uint8_t* second, int pixels) {
    return HWY_DYNAMIC_DISPATCH(row_difference)(first, second, pixels);
}

void mark_row(const std::uint8_t* first, const std::uint8_t* second, int pixels,
              std::uint8_t* out) {
    HWY_DYNAMIC_DISPATCH(mark_row)(first, second, pixels, out);
}

void luminance_row(const std::uint8_t* levels, int pixels, std::int16_t* out) {
    HWY_DYNAMIC_DISPATCH(luminance_row)(levels, pixels, out);
}

void tile_sums(const std::int16_t* a, const std::int16_t* b, std::size_t stride, int rows,
               int tiles, TileSums* out) {
    HWY_DYNAMIC_DISPATCH(tile_sums)(a, b, stride, rows, tiles, out);
}

}  // namespace fumon::level_vectors
#endif
