// Saltation within one row, in two orders:
//
//   synchronous        every cell hops once, all read the row before (Terada 2025, eq. 1)
//   random sequential  one hop after the other, each reads the row as it then is (Sudo 2002,
//                      appendix A)
//
// 1. Synchronous hops leave in loops over vectors (hop_vectors.h). Only the landings, of which
//    several may share a cell, are a loop over cells.
// 2. A sequential hop depends on an earlier one only where that changed its start cell. So vectors
//    compute a block of hops from the row as it is (PrecomputedHops), and the block is applied hop
//    by hop: a start cell that still has the bits it had makes the computed hop right; any other
//    hop is computed anew (hop_from). The result is the plain sequence's, bit for bit.
// 3. A row of 2^15 cells or more exceeds the first-level cache, and waits for memory. There the
//    next block is computed before the present one is applied, and its cells are prefetched:
//
//        short row   apply b       precompute b+1
//        long row    prefetch starts of b+2   precompute b+1   prefetch landings of b+1   apply b
//
//    Blocks are twice as long there. Precomputing earlier costs more hops computed anew, no bits.
// 4. Only linear hops of a constant amount without shadow are precomputed (can_precompute): they
//    depend on the start cell alone.
// 5. Picks are drawn apart from hops: random numbers are functions of seed, row and step, so that
//    another thread can draw the next step's. Words become cells by Lemire's method (2019).

#include "models/sand/row_hops.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/cancellation.h"
#include "base/elementary.h"
#include "models/sand/hop_terms.h"
#include "models/sand/hop_vectors.h"

namespace fumon {

namespace {

constexpr double longest_hop =
    1073741824.0;  // sites, 2^30: longer hops (and NaN) are cut to fit an index

/// Within [0, longest_hop], NaN included, so that it can become an index.
inline double clamped_length(double length) {
    const double cut = length < longest_hop ? length : longest_hop;
    return cut > 0.0 ? cut : 0.0;
}

/// What makes cutting off a fraction rounding.
double to_nearest_of(Landing landing) {
    return landing == Landing::round ? 0.5 : 0.0;
}

inline int wrapped(int x, int nx) {
    if (x < nx) return x;
    return x < 2 * nx ? x - nx : x % nx;
}

/// Piecewise linear between the table's points, constant beyond its ends.
double tabulated(const std::vector<double>& heights, const std::vector<double>& lengths,
                 double height) {
    if (!(height > heights.front())) return lengths.front();
    if (height >= heights.back()) return lengths.back();
    const auto above = std::upper_bound(heights.begin(), heights.end(), height);
    const auto k = static_cast<std::size_t>(above - heights.begin());
    const double share = (height - heights[k - 1]) / (heights[k] - heights[k - 1]);
    return lengths[k - 1] + share * (lengths[k] - lengths[k - 1]);
}

}  // namespace

RowHops::RowHops(const SandParameters& parameters, int nx)
    : parameters_(parameters),
      nx_(nx),
      exponential_rate_(elementary::log(parameters.exponential_base) * 2.0 *
                        parameters.exponential_height),
      exponential_scale_(parameters.exponential_length / 10.0 /
                         (elementary::exp(exponential_rate_) - 1.0)),
      needs_slope_(parameters.hop_length == HopLength::slope ||
                   parameters.hop_amount == HopAmount::slope) {}

double RowHops::length(double height, double slope) const {
    const SandParameters& p = parameters_;
    switch (p.hop_length) {
        case HopLength::linear: {
            const double grown = p.hop_per_height * height;
            return clamped_length(p.hop_base + (p.landing == Landing::truncate_terms
                                                    ? std::trunc(clamped_length(grown))
                                                    : grown));
        }
        case HopLength::slope:
            return clamped_length(p.hop_base - p.hop_slope_factor * elementary::tanh(slope));
        case HopLength::exponential:
            return clamped_length(exponential_scale_ *
                                  (elementary::exp(exponential_rate_ * height) - 1.0));
        case HopLength::tabulated:
            return clamped_length(tabulated(p.hop_table_heights, p.hop_table_lengths, height));
    }
    return 0.0;
}

void RowHops::synchronous(std::span<const double> before, std::span<double> after) {
    amount_.resize(before.size());
    to_.resize(before.size());
    if (needs_slope_) compute_slopes(before);
    depart(before, after);
    if (parameters_.landing == Landing::split) {
        land_split(after);
    } else {
        land(after);
    }
}

void RowHops::compute_slopes(std::span<const double> before) {
    slope_tanh_.resize(before.size());
    const double* h = before.data();
    double* out = slope_tanh_.data();
    const int last = nx_ - 1;
    const auto edge = [&](int x, double left, double right, double factor) {
        out[x] = elementary::tanh(factor * (right - left));
    };
    switch (parameters_.slope_difference) {
        case SlopeDifference::central:
            if (nx_ > 2) hop_vectors::tanh_of_differences(h, h + 2, 0.5, nx_ - 2, out + 1);
            edge(0, h[last], h[1 % nx_], 0.5);
            edge(last, h[(last + nx_ - 1) % nx_], h[0], 0.5);
            break;
        case SlopeDifference::backward:
            hop_vectors::tanh_of_differences(h, h + 1, 1.0, last, out + 1);
            edge(0, h[last], h[0], 1.0);
            break;
        case SlopeDifference::forward:
            hop_vectors::tanh_of_differences(h, h + 1, 1.0, last, out);
            edge(last, h[last], h[0], 1.0);
            break;
    }
}

void RowHops::depart(std::span<const double> before, std::span<double> after) {
    const SandParameters& p = parameters_;
    hop_vectors::AmountLaw amount{p.amount, p.amount_slope_factor, p.limit_amount};
    if (p.hop_amount == HopAmount::slope) amount.slope_tanh = slope_tanh_.data();
    if (p.shadow == Shadow::upwind_higher) {
        upwind_.assign(1, before.back());
        upwind_.insert(upwind_.end(), before.begin(), before.end() - 1);
        amount.upwind = upwind_.data();
    }
    if (p.landing == Landing::split) far_amount_.resize(before.size());
    const hop_vectors::Departures out{
        .width = nx_,
        .from = nullptr,
        .after = after.data(),
        .amount = amount_.data(),
        .far_amount = p.landing == Landing::split ? far_amount_.data() : nullptr,
        .to = to_.data()};
    const double to_nearest = to_nearest_of(p.landing);
    const double* h = before.data();
    const auto hop_linearly = [&](const double* in, double base, double factor) {
        hop_vectors::hop_linearly(h, in, base, factor, to_nearest, amount, nx_, out);
    };
    switch (p.hop_length) {
        case HopLength::linear:
            if (p.landing == Landing::truncate_terms) {
                hop_vectors::hop_linearly_truncated(h, h, p.hop_base, p.hop_per_height, to_nearest,
                                                    amount, nx_, out);
            } else {
                hop_linearly(h, p.hop_base, p.hop_per_height);
            }
            break;
        case HopLength::slope:
            hop_linearly(slope_tanh_.data(), p.hop_base, -p.hop_slope_factor);
            break;
        case HopLength::exponential:
            length_.resize(before.size());
            hop_vectors::exponential_lengths(h, exponential_scale_, exponential_rate_, nx_,
                                             length_.data());
            hop_linearly(length_.data(), 0.0, 1.0);
            break;
        case HopLength::tabulated:
            length_.resize(before.size());
            for (std::size_t x = 0; x < before.size(); ++x) length_[x] = length(before[x], 0.0);
            hop_linearly(length_.data(), 0.0, 1.0);
            break;
    }
}

void RowHops::land(std::span<double> after) const {
    double* row = after.data();
    for (std::size_t x = 0; x < after.size(); ++x) row[to_[x]] += amount_[x];
}

void RowHops::land_split(std::span<double> after) const {
    double* row = after.data();
    for (std::size_t x = 0; x < after.size(); ++x) {
        row[to_[x]] += amount_[x];
        row[to_[x] + 1 == nx_ ? 0 : to_[x] + 1] += far_amount_[x];
    }
}

/// Lemire (2019): the upper half of word · nx, but for the few words that would favour some cells.
void Picks::draw(std::int64_t count, int nx, std::uint64_t seed, std::uint32_t row,
                 std::int64_t step) {
    RandomStream stream(seed, row, step, Purpose::picks);
    words_.resize(static_cast<std::size_t>(count));
    cells_.resize(words_.size());
    stream.fill(words_);
    step_ = step;
    const auto cells = static_cast<std::uint32_t>(nx);
    const std::uint32_t biased = (0U - cells) % cells;
    constexpr std::size_t block = 256;
    for (std::size_t begin = 0; begin < words_.size(); begin += block) {
        const std::size_t end = std::min(begin + block, words_.size());
        const auto pick = [&](std::size_t from, std::size_t to) {
            return hop_vectors::pick_cells(words_.data() + from, cells, biased,
                                           static_cast<int>(to - from), cells_.data() + from);
        };
        if (!pick(begin, end)) continue;
        for (std::size_t k = begin; k < end; ++k) {
            while (pick(k, k + 1)) words_[k] = stream.next32();
        }
    }
}

/// Hops worked out by vectors before those that come earlier have been done: right wherever the
/// height is still what it was then.
struct RowHops::PrecomputedHops {
    static constexpr std::size_t most = 64;
    template <class Value>
    using Each = std::array<Value, most>;

    std::span<const std::int32_t> from;
    alignas(64) Each<double> height;
    alignas(64) Each<double> after;
    alignas(64) Each<double> amount;
    alignas(64) Each<double> far_amount;
    alignas(64) Each<std::int32_t> to;
};

/// The commonest rule: linear hops that carry q0.
bool RowHops::can_precompute() const {
    return parameters_.hop_length == HopLength::linear &&
           parameters_.hop_amount == HopAmount::constant && parameters_.shadow == Shadow::none;
}

void RowHops::precompute_hops(const double* row, std::span<const std::int32_t> cells,
                              PrecomputedHops& hops) const {
    const SandParameters& p = parameters_;
    hops.from = cells;
    for (std::size_t k = 0; k < cells.size(); ++k) hops.height[k] = row[cells[k]];
    const double* h = hops.height.data();
    const int count = static_cast<int>(cells.size());
    const hop_vectors::AmountLaw amount{
        .base = p.amount, .limited = p.limit_amount, .from_sand_only = true};
    const hop_vectors::Departures out{
        .width = nx_,
        .from = cells.data(),
        .after = hops.after.data(),
        .amount = hops.amount.data(),
        .far_amount = p.landing == Landing::split ? hops.far_amount.data() : nullptr,
        .to = hops.to.data()};
    if (p.landing == Landing::truncate_terms) {
        hop_vectors::hop_linearly_truncated(h, h, p.hop_base, p.hop_per_height, 0.0, amount, count,
                                            out);
    } else {
        hop_vectors::hop_linearly(h, h, p.hop_base, p.hop_per_height, to_nearest_of(p.landing),
                                  amount, count, out);
    }
}

template <bool split>
void RowHops::apply_precomputed(double* row, const PrecomputedHops& hops) const {
    for (std::size_t k = 0; k < hops.from.size(); ++k) {
        const int x = hops.from[k];
        if (std::bit_cast<std::uint64_t>(row[x]) != std::bit_cast<std::uint64_t>(hops.height[k]))
            [[unlikely]] {
            hop_from(row, x);
            continue;
        }
        const int to = hops.to[k];
        row[x] = hops.after[k];
        row[to] += hops.amount[k];
        if constexpr (split) row[to + 1 == nx_ ? 0 : to + 1] += hops.far_amount[k];
    }
}

/// Of a long row the cells that hops start from and land in are called for blocks ahead, so that
/// they are on their way from memory when they are needed.
void RowHops::random_sequential(std::span<double> row, const Picks& picks) const {
    const auto cells = picks.cells();
    if (!can_precompute()) {
        for (const std::int32_t x : cells) {
            throw_if_cancelled();
            hop_from(row.data(), x);
        }
        return;
    }
    constexpr int is_long = 1 << 15;  // cells, more than the first-level cache holds
    const bool far = nx_ >= is_long;
    const std::size_t block = far ? PrecomputedHops::most : PrecomputedHops::most / 2;
    const auto picked = [&](std::size_t begin) {
        begin = std::min(begin, cells.size());
        return cells.subspan(begin, std::min(block, cells.size() - begin));
    };
    std::array<PrecomputedHops, 2> hops;
    precompute_hops(row.data(), picked(0), hops[0]);
    for (std::size_t begin = 0; begin < cells.size(); begin += block) {
        throw_if_cancelled();
        const PrecomputedHops& now = hops[begin / block % 2];
        PrecomputedHops& next = hops[(begin / block + 1) % 2];
        if (far) {
            for (const std::int32_t x : picked(begin + 2 * block))
                __builtin_prefetch(row.data() + x, 1);
            precompute_hops(row.data(), picked(begin + block), next);
            for (std::size_t k = 0; k < next.from.size(); ++k)
                __builtin_prefetch(row.data() + next.to[k], 1);
        }
        if (parameters_.landing == Landing::split) {
            apply_precomputed<true>(row.data(), now);
        } else {
            apply_precomputed<false>(row.data(), now);
        }
        if (!far) precompute_hops(row.data(), picked(begin + block), next);
    }
}

/// One hop, if there is sand and wind: reads the row as it is now.
inline void RowHops::hop_from(double* row, int x) const {
    const SandParameters& p = parameters_;
    const double height = row[x];
    double slope = 0.0;
    if (needs_slope_) {
        const double left = row[x == 0 ? nx_ - 1 : x - 1];
        const double right = row[x + 1 == nx_ ? 0 : x + 1];
        slope = slope_at(p.slope_difference, left, height, right);
    }
    double carried = hop_amount(p, height, slope);
    carried = height > 0.0 ? carried : 0.0;
    if (p.shadow == Shadow::upwind_higher)
        carried = row[x == 0 ? nx_ - 1 : x - 1] > height ? 0.0 : carried;

    double reach = length(height, slope);
    if (p.landing == Landing::round) reach += 0.5;
    const int whole = static_cast<int>(reach);
    const double far_amount =
        p.landing == Landing::split ? carried * (reach - static_cast<double>(whole)) : 0.0;
    row[x] -= carried;
    row[wrapped(x + whole, nx_)] += carried - far_amount;
    if (p.landing == Landing::split) row[wrapped(x + whole + 1, nx_)] += far_amount;
}

}  // namespace fumon
