#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measure/bed/row_pass_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>

#include "measure/bed/row_pass_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::row_passes {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Eight = hn::CappedTag<double, lanes>;
using EightVector = hn::Vec<Eight>;

/// Calls take(vector) for the lanes from `k` on of eight values after eight; past the last whole
/// eight come `fill`.
template <class Take>
HWY_INLINE void for_eights(std::span<const double> values, double fill, std::size_t k,
                           const Take& take) {
    const Eight d;
    std::size_t x = 0;
    for (; x + lanes <= values.size(); x += lanes) take(hn::LoadU(d, values.data() + x + k));
    if (x == values.size()) return;
    HWY_ALIGN double rest[lanes];
    std::fill(rest, rest + lanes, fill);
    std::copy(values.begin() + static_cast<std::ptrdiff_t>(x), values.end(), rest);
    take(hn::Load(d, rest + k));
}

HWY_INLINE void add_term(EightVector term, EightVector& sum, EightVector& lost) {
    const EightVector next = hn::Add(sum, term);
    const auto sum_is_larger = hn::Ge(hn::Abs(sum), hn::Abs(term));
    const EightVector larger = hn::IfThenElse(sum_is_larger, sum, term);
    const EightVector smaller = hn::IfThenElse(sum_is_larger, term, sum);
    lost = hn::Add(lost, hn::Add(hn::Sub(larger, next), smaller));
    sum = next;
}

void add(std::span<const double> values, Sums& sums) {
    const Eight d;
    for (std::size_t k = 0; k < lanes; k += hn::Lanes(d)) {
        EightVector sum = hn::LoadU(d, sums.sum.data() + k);
        EightVector lost = hn::LoadU(d, sums.lost.data() + k);
        EightVector lowest = hn::LoadU(d, sums.lowest.data() + k);
        EightVector highest = hn::LoadU(d, sums.highest.data() + k);
        std::size_t x = 0;
        for (; x + lanes <= values.size(); x += lanes) {
            const EightVector value = hn::LoadU(d, values.data() + x + k);
            lowest = hn::Min(lowest, value);
            highest = hn::Max(highest, value);
            add_term(value, sum, lost);
        }
        hn::StoreU(sum, d, sums.sum.data() + k);
        hn::StoreU(lost, d, sums.lost.data() + k);
        hn::StoreU(lowest, d, sums.lowest.data() + k);
        hn::StoreU(highest, d, sums.highest.data() + k);
    }
    const std::size_t rest = values.size() % lanes;
    if (rest == 0) return;
    HWY_ALIGN double some[lanes] = {};
    std::copy(values.end() - static_cast<std::ptrdiff_t>(rest), values.end(), some);
    for (std::size_t k = 0; k < rest; ++k) {
        sums.lowest[k] = std::min(sums.lowest[k], some[k]);
        sums.highest[k] = std::max(sums.highest[k], some[k]);
    }
    for (std::size_t k = 0; k < lanes; k += hn::Lanes(d)) {
        EightVector sum = hn::LoadU(d, sums.sum.data() + k);
        EightVector lost = hn::LoadU(d, sums.lost.data() + k);
        add_term(hn::Load(d, some + k), sum, lost);
        hn::StoreU(sum, d, sums.sum.data() + k);
        hn::StoreU(lost, d, sums.lost.data() + k);
    }
}

void add_squares(std::span<const double> values, double mean, Sums& sums) {
    const Eight d;
    const EightVector middle = hn::Set(d, mean);
    for (std::size_t k = 0; k < lanes; k += hn::Lanes(d)) {
        EightVector sum = hn::LoadU(d, sums.sum.data() + k);
        EightVector lost = hn::LoadU(d, sums.lost.data() + k);
        for_eights(values, mean, k, [&](EightVector value) HWY_ATTR {
            const EightVector departure = hn::Sub(value, middle);
            add_term(hn::Mul(departure, departure), sum, lost);
        });
        hn::StoreU(sum, d, sums.sum.data() + k);
        hn::StoreU(lost, d, sums.lost.data() + k);
    }
}

double highest(std::span<const double> values, double least) {
    const hn::ScalableTag<double> d;
    auto most = hn::Set(d, least);
    auto more = most;
    const std::size_t step = hn::Lanes(d);
    std::size_t x = 0;
    for (; x + 2 * step <= values.size(); x += 2 * step) {
        most = hn::Max(most, hn::LoadU(d, values.data() + x));
        more = hn::Max(more, hn::LoadU(d, values.data() + x + step));
    }
    double result = hn::GetLane(hn::MaxOfLanes(d, hn::Max(most, more)));
    for (; x < values.size(); ++x) result = std::max(result, values[x]);
    return result;
}

double highest_magnitude(std::span<const double> values) {
    const hn::ScalableTag<double> d;
    auto most = hn::Zero(d);
    auto more = most;
    const std::size_t step = hn::Lanes(d);
    std::size_t x = 0;
    for (; x + 2 * step <= values.size(); x += 2 * step) {
        most = hn::Max(most, hn::Abs(hn::LoadU(d, values.data() + x)));
        more = hn::Max(more, hn::Abs(hn::LoadU(d, values.data() + x + step)));
    }
    double result = hn::GetLane(hn::MaxOfLanes(d, hn::Max(most, more)));
    for (; x < values.size(); ++x)
        result = std::max(result, values[x] < 0 ? -values[x] : values[x]);
    return result;
}

void differences(std::span<const double> row, double* out) {
    const hn::ScalableTag<double> d;
    const std::size_t count = row.size() - 1;
    std::size_t x = 0;
    for (; x + hn::Lanes(d) <= count; x += hn::Lanes(d)) {
        const auto here = hn::LoadU(d, row.data() + x);
        hn::StoreU(hn::Sub(hn::LoadU(d, row.data() + x + 1), here), d, out + x);
    }
    for (; x < count; ++x) out[x] = row[x + 1] - row[x];
}

std::size_t keep_above(std::span<const double> values, double sign, double level, double* kept) {
    const hn::ScalableTag<double> d;
    const auto least = hn::Set(d, level);
    const auto factor = hn::Set(d, sign);
    std::size_t count = 0;
    std::size_t x = 0;
    for (; x + hn::Lanes(d) <= values.size(); x += hn::Lanes(d)) {
        const auto value = hn::Mul(hn::LoadU(d, values.data() + x), factor);
        count += hn::CompressStore(value, hn::Gt(value, least), d, kept + count);
    }
    for (; x < values.size(); ++x) {
        kept[count] = values[x] * sign;
        count += static_cast<std::size_t>(kept[count] > level);
    }
    return count;
}

Kept keep_between(std::span<const double> values, double low, double high, double* kept) {
    const hn::ScalableTag<double> d;
    const auto from = hn::Set(d, low);
    const auto to = hn::Set(d, high);
    Kept result;
    std::size_t x = 0;
    for (; x + hn::Lanes(d) <= values.size(); x += hn::Lanes(d)) {
        const auto value = hn::LoadU(d, values.data() + x);
        const auto below = hn::Lt(value, from);
        const auto between = hn::AndNot(below, hn::Le(value, to));
        result.below += hn::CountTrue(d, below);
        if (hn::AllFalse(d, between)) continue;
        result.count += hn::CompressStore(value, between, d, kept + result.count);
    }
    for (; x < values.size(); ++x) {
        kept[result.count] = values[x];
        result.count += static_cast<std::size_t>(values[x] >= low && values[x] <= high);
        result.below += static_cast<std::size_t>(values[x] < low);
    }
    return result;
}

void mark_above(std::span<const double> values, double level, std::uint64_t* words) {
    const hn::ScalableTag<double> d;
    constexpr std::size_t word = 64;
    const auto least = hn::Set(d, level);
    std::fill_n(words, (values.size() + word - 1) / word, std::uint64_t{0});
    std::size_t x = 0;
    for (; x + hn::Lanes(d) <= values.size(); x += hn::Lanes(d)) {
        const auto above = hn::Gt(hn::LoadU(d, values.data() + x), least);
        std::array<std::uint8_t, 8> bits{};
        hn::StoreMaskBits(d, above, bits.data());
        words[x / word] |= std::uint64_t{bits[0]} << (x % word);
    }
    for (; x < values.size(); ++x)
        words[x / word] |= static_cast<std::uint64_t>(values[x] > level) << (x % word);
}

/// h'(0) from the sites at −2, −1, 1, 2.
template <class V>
HWY_INLINE V slope_of(V west2, V west, V east, V east2) {
    const hn::DFromV<V> d;
    const V near = hn::Mul(hn::Set(d, 8.0), hn::Sub(east, west));
    return hn::Div(hn::Sub(near, hn::Sub(east2, west2)), hn::Set(d, 12.0));
}

void slope_products(const std::array<const double*, 5>& rows, std::size_t nx, double* xx,
                    double* xy, double* yy) {
    constexpr std::size_t reach = 2;
    const auto loop = [&](auto d, std::size_t x) HWY_ATTR {
        const double* here = rows[2] + x;
        const auto along = slope_of(hn::LoadU(d, here - 2), hn::LoadU(d, here - 1),
                                    hn::LoadU(d, here + 1), hn::LoadU(d, here + 2));
        const auto across = slope_of(hn::LoadU(d, rows[0] + x), hn::LoadU(d, rows[1] + x),
                                     hn::LoadU(d, rows[3] + x), hn::LoadU(d, rows[4] + x));
        hn::StoreU(hn::Mul(along, along), d, xx + x);
        hn::StoreU(hn::Mul(along, across), d, xy + x);
        hn::StoreU(hn::Mul(across, across), d, yy + x);
    };
    const hn::ScalableTag<double> doubles;
    const hn::CappedTag<double, 1> one;
    std::size_t x = reach;
    for (; x + hn::Lanes(doubles) + reach <= nx; x += hn::Lanes(doubles)) loop(doubles, x);
    for (; x + reach < nx; ++x) loop(one, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::row_passes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::row_passes {

HWY_EXPORT(add);
HWY_EXPORT(add_squares);
HWY_EXPORT(highest);
HWY_EXPORT(highest_magnitude);
HWY_EXPORT(differences);
HWY_EXPORT(keep_above);
HWY_EXPORT(keep_between);
HWY_EXPORT(mark_above);
HWY_EXPORT(slope_products);

void add(std::span<const double> values, Sums& sums) {
    HWY_DYNAMIC_DISPATCH(add)(values, sums);
}

void add_squares(std::span<const double> values, double mean, Sums& sums) {
    HWY_DYNAMIC_DISPATCH(add_squares)(values, mean, sums);
}

double highest(std::span<const double> values, double least) {
    return HWY_DYNAMIC_DISPATCH(highest)(values, least);
}

double highest_magnitude(std::span<const double> values) {
    return HWY_DYNAMIC_DISPATCH(highest_magnitude)(values);
}

void differences(std::span<const double> row, double* out) {
    HWY_DYNAMIC_DISPATCH(differences)(row, out);
}

std::size_t keep_above(std::span<const double> values, double sign, double level, double* kept) {
    return HWY_DYNAMIC_DISPATCH(keep_above)(values, sign, level, kept);
}

Kept keep_between(std::span<const double> values, double low, double high, double* kept) {
    return HWY_DYNAMIC_DISPATCH(keep_between)(values, low, high, kept);
}

void mark_above(std::span<const double> values, double level, std::uint64_t* words) {
    HWY_DYNAMIC_DISPATCH(mark_above)(values, level, words);
}

void slope_products(const std::array<const double*, 5>& rows, std::size_t nx, double* xx,
                    double* xy, double* yy) {
    HWY_DYNAMIC_DISPATCH(slope_products)(rows, nx, xx, xy, yy);
}

}  // namespace fumon::row_passes
#endif
