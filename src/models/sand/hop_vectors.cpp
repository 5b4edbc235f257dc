#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/sand/hop_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <cstddef>
#include <limits>

#include "models/sand/hop_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::hop_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

constexpr std::size_t at_once = 8;  // vectors, of whose elementary functions stages overlap

/// Within [0, 2^30], NaN included.
template <class V>
HWY_INLINE V usable(V length) {
    return greater(lesser(length, constant<V>(1073741824.0)), constant<V>(0.0));
}

struct TanhOfDifference {
    const double* left;
    const double* right;
    double factor;
    double* out;

    template <class D, class Several>
    HWY_INLINE void operator()(D d, std::size_t x, Several several) const {
        hn::Vec<D> some[several];
        for (std::size_t i = 0; i < several; ++i) {
            const std::size_t at = x + i * hn::MaxLanes(d);
            some[i] = hn::Set(d, factor) * (hn::LoadU(d, right + at) - hn::LoadU(d, left + at));
        }
        vectors::HWY_NAMESPACE::tanh(some);
        for (std::size_t i = 0; i < several; ++i)
            hn::StoreU(some[i], d, out + x + i * hn::MaxLanes(d));
    }
};

struct ExponentialLength {
    const double* in;
    double scale;
    double rate;
    double* out;

    template <class D, class Several>
    HWY_INLINE void operator()(D d, std::size_t x, Several several) const {
        hn::Vec<D> some[several];
        for (std::size_t i = 0; i < several; ++i)
            some[i] = hn::Set(d, rate) * hn::LoadU(d, in + x + i * hn::MaxLanes(d));
        vectors::HWY_NAMESPACE::exp(some);
        for (std::size_t i = 0; i < several; ++i) {
            const auto length = hn::Set(d, scale) * (some[i] - hn::Set(d, 1.0));
            hn::StoreU(length, d, out + x + i * hn::MaxLanes(d));
        }
    }
};

struct Linear {
    double base;
    double factor;

    template <class V>
    HWY_INLINE V operator()(V in) const {
        return usable(constant<V>(base) + constant<V>(factor) * in);
    }
};

struct LinearTruncated {
    double base;
    double factor;

    template <class V>
    HWY_INLINE V operator()(V in) const {
        return usable(constant<V>(base) + hn::Trunc(usable(constant<V>(factor) * in)));
    }
};

/// Of all cells of a row and of picked ones, by the laws that are used most; and any other.
enum class Hops { row, picked, any };

template <class Length, bool of_slope, Hops hops>
struct Depart {
    const double* height;
    const double* in;
    Length length;
    double to_nearest;
    AmountLaw law;
    Departures out;

    template <class D>
    HWY_INLINE hn::Vec<D> amount(D d, hn::Vec<D> h, std::size_t x) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        V wanted = hn::Set(d, law.base);
        if constexpr (of_slope) {
            const V slope = hn::LoadU(d, law.slope_tanh + x);
            wanted = greater(wanted + hn::Set(d, law.slope_factor) * slope, zero);
        }
        // at least this of a height counts as there: more than any amount where none is limited
        const double there = law.limited ? 0.0 : std::numeric_limits<double>::infinity();
        V carried = lesser(wanted, greater(h, hn::Set(d, there)));
        if (hops == Hops::picked || (hops == Hops::any && law.from_sand_only))
            carried = hn::IfThenElseZero(hn::Gt(h, zero), carried);
        if (hops != Hops::any || law.upwind == nullptr) return carried;
        return hn::IfThenZeroElse(hn::Gt(hn::LoadU(d, law.upwind + x), h), carried);
    }

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const hn::Rebind<std::int32_t, D> cells;
        const V h = hn::LoadU(d, height + x);
        const V carried = amount(d, h, x);
        const V reach = length(hn::LoadU(d, in + x)) + hn::Set(d, to_nearest);
        const auto whole = hn::DemoteTo(cells, reach);
        hn::StoreU(h - carried, d, out.after + x);
        if (hops != Hops::any || out.far_amount == nullptr) {
            hn::StoreU(carried, d, out.amount + x);
        } else {
            const V beyond = carried * (reach - hn::PromoteTo(d, whole));
            hn::StoreU(carried - beyond, d, out.amount + x);
            hn::StoreU(beyond, d, out.far_amount + x);
        }
        const bool picked = hops == Hops::picked || (hops == Hops::any && out.from != nullptr);
        const auto here = picked
                              ? hn::LoadU(cells, out.from + x)
                              : hn::Set(cells, static_cast<std::int32_t>(x)) + hn::Iota(cells, 0);
        const auto width = hn::Set(cells, out.width);
        const auto straight = here + whole;
        const auto round = straight - hn::IfThenZeroElse(hn::Lt(straight, width), width);
        hn::StoreU(round, cells, out.to + x);
        if (HWY_LIKELY(hn::AllTrue(cells, hn::Lt(round, width)))) return;
        for (std::size_t k = x; k < x + hn::MaxLanes(d); ++k) out.to[k] %= out.width;
    }
};

template <bool of_slope, class Length>
HWY_INLINE void depart(const double* height, const double* in, const Length& length,
                       double to_nearest, const AmountLaw& law, int count, const Departures& out) {
    const bool usual = law.upwind == nullptr && out.far_amount == nullptr;
    if (usual && out.from == nullptr && !law.from_sand_only) {
        for_each_vector(
            count, Depart<Length, of_slope, Hops::row>{height, in, length, to_nearest, law, out});
    } else if (usual && out.from != nullptr && law.from_sand_only) {
        for_each_vector(count, Depart<Length, of_slope, Hops::picked>{height, in, length,
                                                                      to_nearest, law, out});
    } else {
        for_each_vector(
            count, Depart<Length, of_slope, Hops::any>{height, in, length, to_nearest, law, out});
    }
}

template <class Length>
HWY_INLINE void depart(const double* height, const double* in, const Length& length,
                       double to_nearest, const AmountLaw& law, int count, const Departures& out) {
    if (law.slope_tanh == nullptr) {
        depart<false>(height, in, length, to_nearest, law, count, out);
    } else {
        depart<true>(height, in, length, to_nearest, law, count, out);
    }
}

bool pick_cells(const std::uint32_t* words, std::uint32_t nx, std::uint32_t biased, int count,
                std::int32_t* cells) {
    const auto picks = static_cast<std::size_t>(count);
    std::size_t k = 0;
    bool favoured = false;
#if HWY_TARGET != HWY_SCALAR
    const hn::ScalableTag<std::uint32_t> d;
    const hn::RepartitionToWide<decltype(d)> wide;
    const hn::RebindToSigned<decltype(d)> as_cells;
    const auto width = hn::Set(d, nx);
    auto lowest = hn::Set(d, ~std::uint32_t{0});
    constexpr int half = 32;
    const auto odd = hn::BitCast(d, hn::Set(wide, ~std::uint64_t{0} << half));
    for (; k + hn::MaxLanes(d) <= picks; k += hn::MaxLanes(d)) {
        const auto word = hn::LoadU(d, words + k);
        const auto of_even = hn::MulEven(word, width);
        const auto of_odd =
            hn::MulEven(hn::BitCast(d, hn::ShiftRight<half>(hn::BitCast(wide, word))), width);
        const auto upper = hn::Or(hn::BitCast(d, hn::ShiftRight<half>(of_even)),
                                  hn::And(odd, hn::BitCast(d, of_odd)));
        const auto lower = hn::Or(hn::AndNot(odd, hn::BitCast(d, of_even)),
                                  hn::BitCast(d, hn::ShiftLeft<half>(of_odd)));
        lowest = hn::Min(lowest, lower);
        hn::StoreU(hn::BitCast(as_cells, upper), as_cells, cells + k);
    }
    favoured = hn::GetLane(hn::MinOfLanes(d, lowest)) < biased;
#endif
    for (; k < picks; ++k) {
        const std::uint64_t product = static_cast<std::uint64_t>(words[k]) * nx;
        favoured |= static_cast<std::uint32_t>(product) < biased;
        cells[k] = static_cast<std::int32_t>(product >> 32);
    }
    return favoured;
}

void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out) {
    for_each_group<at_once>(count, TanhOfDifference{left, right, factor, out});
}

void exponential_lengths(const double* in, double scale, double rate, int count, double* out) {
    for_each_group<at_once>(count, ExponentialLength{in, scale, rate, out});
}

void hop_linearly(const double* height, const double* in, double base, double factor,
                  double to_nearest, const AmountLaw& amount, int count, const Departures& out) {
    depart(height, in, Linear{base, factor}, to_nearest, amount, count, out);
}

void hop_linearly_truncated(const double* height, const double* in, double base, double factor,
                            double to_nearest, const AmountLaw& amount, int count,
                            const Departures& out) {
    depart(height, in, LinearTruncated{base, factor}, to_nearest, amount, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::hop_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::hop_vectors {

HWY_EXPORT(pick_cells);
HWY_EXPORT(tanh_of_differences);
HWY_EXPORT(exponential_lengths);
HWY_EXPORT(hop_linearly);
HWY_EXPORT(hop_linearly_truncated);

bool pick_cells(const std::uint32_t* words, std::uint32_t nx, std::uint32_t biased, int count,
                std::int32_t* cells) {
    return HWY_DYNAMIC_DISPATCH(pick_cells)(words, nx, biased, count, cells);
}

void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out) {
    HWY_DYNAMIC_DISPATCH(tanh_of_differences)(left, right, factor, count, out);
}

void exponential_lengths(const double* in, double scale, double rate, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(exponential_lengths)(in, scale, rate, count, out);
}

void hop_linearly(const double* height, const double* in, double base, double factor,
                  double to_nearest, const AmountLaw& amount, int count, const Departures& out) {
    HWY_DYNAMIC_DISPATCH(hop_linearly)(height, in, base, factor, to_nearest, amount, count, out);
}

void hop_linearly_truncated(const double* height, const double* in, double base, double factor,
                            double to_nearest, const AmountLaw& amount, int count,
                            const Departures& out) {
    HWY_DYNAMIC_DISPATCH(hop_linearly_truncated)
    (height, in, base, factor, to_nearest, amount, count, out);
}

}  // namespace fumon::hop_vectors
#endif
