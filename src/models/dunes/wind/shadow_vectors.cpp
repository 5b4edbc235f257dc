#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/dunes/wind/shadow_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>
#include <cstddef>

#include "models/dunes/wind/shadow_vectors.h"
#include "models/shared/fixed_point_lengths.h"
#include "vectors/functions-inl.h"
#include "vectors/integers-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::shadow_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

template <bool with_shade, bool with_envelope>
HWY_INLINE void advance_line_vector(const Lines& lines, const Fall& fall, const Between& between,
                                    double range, double* shade, double* envelope) {
    const hn::ScalableTag<double> doubles;
    const auto near = hn::Set(doubles, 1.0 - between.beyond);
    const auto beyond = hn::Set(doubles, between.beyond);
    const auto zero = hn::Zero(doubles);
    const auto one = hn::Set(doubles, 1.0);
    const auto room_of_range = hn::Set(doubles, range);
    constexpr double thinnest = 1e-9;  // m: a hard edge
    // A vector of lines stays as it was until the one before, which reads its first, is done.
    for (std::size_t i = 0; i < static_cast<std::size_t>(lines.count); i += hn::Lanes(doubles)) {
        const auto fallen = [&](const double* line, double change) HWY_ATTR {
            return hn::Add(hn::LoadU(doubles, line), hn::Set(doubles, change));
        };
        const auto soft = fallen(lines.soft + i, -fall.soft);
        const auto full = fallen(lines.full + i, -fall.full);
        const auto since = fallen(lines.since + i, fall.length);
        const auto here = hn::LoadU(doubles, between.heights + i);
        const auto next = hn::LoadU(doubles, between.heights + i + 1);
        if (with_shade) {
            const auto blend = [&](auto line, auto line_after) HWY_ATTR {
                return hn::Add(hn::Mul(line_after, near), hn::Mul(line, beyond));
            };
            const auto full_between = blend(full, fallen(lines.full + i + 1, -fall.full));
            const auto since_between = blend(since, fallen(lines.since + i + 1, fall.length));
            const auto soft_between = blend(soft, fallen(lines.soft + i + 1, -fall.soft));
            const auto room =
                greater(hn::Mul(since_between, room_of_range), hn::Set(doubles, thinnest));
            const auto below = hn::Div(hn::Sub(soft_between, next), room);
            const auto partly = lesser(greater(below, zero), one);
            hn::StoreU(hn::IfThenElse(hn::Gt(full_between, next), one, partly), doubles, shade + i);
            if (with_envelope) hn::StoreU(greater(full_between, next), doubles, envelope + i);
        }
        const auto ground = hn::Add(hn::Mul(here, near), hn::Mul(next, beyond));
        const auto below = hn::Gt(soft, ground);
        hn::StoreU(hn::IfThenElseZero(below, since), doubles, lines.since + i);
        hn::StoreU(hn::IfThenElse(below, soft, ground), doubles, lines.soft + i);
        hn::StoreU(greater(full, ground), doubles, lines.full + i);
    }
}

void advance_lines(const Lines& lines, const Fall& fall, const Between& between, double range,
                   double* shade, double* envelope) {
    if (shade == nullptr) {
        advance_line_vector<false, false>(lines, fall, between, range, shade, envelope);
    } else if (envelope == nullptr) {
        advance_line_vector<true, false>(lines, fall, between, range, shade, envelope);
    } else {
        advance_line_vector<true, true>(lines, fall, between, range, shade, envelope);
    }
}

void to_metres(const std::int64_t* units, int count, double* metres) {
    const auto loop = [&](auto doubles, std::size_t x) HWY_ATTR {
        const auto number =
            hn::Sub(load_offset_integers(doubles, units + x), hn::Set(doubles, integer_offset));
        hn::StoreU(hn::Mul(number, hn::Set(doubles, metres_per_unit)), doubles, metres + x);
    };
    for_each_vector(count, loop);
}

void range_of_row(const std::int64_t* heights, int count, std::int64_t& lowest,
                  std::int64_t& highest) {
    const hn::ScalableTag<std::int64_t> whole;
    constexpr std::size_t lanes = hn::MaxLanes(whole);
    const auto cells = static_cast<std::size_t>(count);
    auto low = hn::Set(whole, heights[0]);
    auto high = low;
    std::size_t x = 0;
    for (; x + lanes <= cells; x += lanes) {
        const auto here = hn::LoadU(whole, heights + x);
        low = hn::Min(low, here);
        high = hn::Max(high, here);
    }
    HWY_ALIGN std::int64_t lows[lanes];
    HWY_ALIGN std::int64_t highs[lanes];
    hn::Store(low, whole, lows);
    hn::Store(high, whole, highs);
    lowest = *std::min_element(lows, lows + lanes);
    highest = *std::max_element(highs, highs + lanes);
    for (; x < cells; ++x) {
        lowest = std::min(lowest, heights[x]);
        highest = std::max(highest, heights[x]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::shadow_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::shadow_vectors {

HWY_EXPORT(advance_lines);
HWY_EXPORT(to_metres);
HWY_EXPORT(range_of_row);

void advance_lines(const Lines& lines, const Fall& fall, const Between& between, double range,
                   double* shade, double* envelope) {
    HWY_DYNAMIC_DISPATCH(advance_lines)(lines, fall, between, range, shade, envelope);
}

void to_metres(const std::int64_t* units, int count, double* metres) {
    HWY_DYNAMIC_DISPATCH(to_metres)(units, count, metres);
}

void range_of_row(const std::int64_t* heights, int count, std::int64_t& lowest,
                  std::int64_t& highest) {
    HWY_DYNAMIC_DISPATCH(range_of_row)(heights, count, lowest, highest);
}

}  // namespace fumon::shadow_vectors
#endif
