#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/dunes/shadow_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>
#include <cstddef>

#include "models/dunes/shadow_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::shadow_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

void fall(const Lines& lines, const Fall& fall) {
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto add = [&](double* line, double change) HWY_ATTR {
            hn::StoreU(hn::Add(hn::LoadU(doubles, line + i), hn::Set(doubles, change)), doubles,
                       line + i);
        };
        add(lines.soft, -fall.soft);
        add(lines.full, -fall.full);
        add(lines.since, fall.length);
    };
    for_each_vector(lines.count, loop);
}

void shade(const Lines& lines, const Between& between, double range, double* shade,
           double* envelope) {
    const double near = 1.0 - between.beyond;
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto blend = [&](const double* line) HWY_ATTR {
            return hn::Add(hn::Mul(hn::LoadU(doubles, line + i + 1), hn::Set(doubles, near)),
                           hn::Mul(hn::LoadU(doubles, line + i), hn::Set(doubles, between.beyond)));
        };
        constexpr double thinnest = 1e-9;  // m: a hard edge
        const auto ground = hn::LoadU(doubles, between.heights + i + 1);
        const auto full = blend(lines.full);
        const auto room = greater(hn::Mul(blend(lines.since), hn::Set(doubles, range)),
                                  hn::Set(doubles, thinnest));
        const auto below = hn::Div(hn::Sub(blend(lines.soft), ground), room);
        const auto one = hn::Set(doubles, 1.0);
        const auto partly = lesser(greater(below, hn::Zero(doubles)), one);
        hn::StoreU(hn::IfThenElse(hn::Gt(full, ground), one, partly), doubles, shade + i);
        hn::StoreU(greater(full, ground), doubles, envelope + i);
    };
    for_each_vector(lines.count - 1, loop);
}

void lift(const Lines& lines, const Between& between) {
    const double near = 1.0 - between.beyond;
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto ground = hn::Add(
            hn::Mul(hn::LoadU(doubles, between.heights + i), hn::Set(doubles, near)),
            hn::Mul(hn::LoadU(doubles, between.heights + i + 1), hn::Set(doubles, between.beyond)));
        const auto soft = hn::LoadU(doubles, lines.soft + i);
        const auto since = hn::LoadU(doubles, lines.since + i);
        const auto below = hn::Gt(soft, ground);
        hn::StoreU(hn::IfThenElseZero(below, since), doubles, lines.since + i);
        hn::StoreU(hn::IfThenElse(below, soft, ground), doubles, lines.soft + i);
        hn::StoreU(greater(hn::LoadU(doubles, lines.full + i), ground), doubles, lines.full + i);
    };
    for_each_vector(lines.count, loop);
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

HWY_EXPORT(fall);
HWY_EXPORT(shade);
HWY_EXPORT(lift);
HWY_EXPORT(range_of_row);

void fall(const Lines& lines, const Fall& fall) {
    HWY_DYNAMIC_DISPATCH(fall)(lines, fall);
}

void shade(const Lines& lines, const Between& between, double range, double* shade,
           double* envelope) {
    HWY_DYNAMIC_DISPATCH(shade)(lines, between, range, shade, envelope);
}

void lift(const Lines& lines, const Between& between) {
    HWY_DYNAMIC_DISPATCH(lift)(lines, between);
}

void range_of_row(const std::int64_t* heights, int count, std::int64_t& lowest,
                  std::int64_t& highest) {
    HWY_DYNAMIC_DISPATCH(range_of_row)(heights, count, lowest, highest);
}

}  // namespace fumon::shadow_vectors
#endif
