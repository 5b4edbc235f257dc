#include "models/sand/row_hops.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "base/give_up.h"
#include "models/sand/hop_vectors.h"

namespace fumon {

namespace {

constexpr double longest_hop =
    1073741824.0;  // sites, 2^30: longer hops (and NaN) are cut to fit an index

/// Within [0, longest_hop], NaN included, so that it can become an index.
inline double usable(double length) {
    const double cut = length < longest_hop ? length : longest_hop;
    return cut > 0.0 ? cut : 0.0;
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
            return usable(p.hop_base + (p.landing == Landing::truncate_terms
                                            ? std::trunc(usable(grown))
                                            : grown));
        }
        case HopLength::slope:
            return usable(p.hop_base - p.hop_slope_factor * elementary::tanh(slope));
        case HopLength::exponential:
            return usable(exponential_scale_ * (elementary::exp(exponential_rate_ * height) - 1.0));
        case HopLength::tabulated:
            return usable(tabulated(p.hop_table_heights, p.hop_table_lengths, height));
    }
    return 0.0;
}

void RowHops::synchronous(std::span<const double> before, std::span<double> after) {
    amount_.resize(before.size());
    to_.resize(before.size());
    if (needs_slope_) take_slopes(before);
    depart(before, after);
    if (parameters_.landing == Landing::split) {
        land_split(after);
    } else {
        land(after);
    }
}

void RowHops::take_slopes(std::span<const double> before) {
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
    const hop_vectors::Departures out{after.data(), amount_.data(),
                                      p.landing == Landing::split ? far_amount_.data() : nullptr,
                                      to_.data()};
    const double to_nearest = p.landing == Landing::round ? 0.5 : 0.0;
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

void Picks::draw(std::int64_t count, std::uint64_t seed, std::uint32_t row, std::int64_t step) {
    rest_ = RandomStream(seed, row, step, Purpose::picks);
    words_.resize(static_cast<std::size_t>(count));
    rest_.fill(words_);
    step_ = step;
}

/// Calls hop(x) for the cell of every pick, in order. The cells of a block are worked out first, so
/// that those of a long row are on their way from memory when they are needed.
template <class Hop>
inline void RowHops::hop_from_each(double* row, const Picks& picks, Hop hop) const {
    constexpr std::size_t block = 128;
    std::array<int, block> cells{};
    RandomStream rest = picks.rest();
    const auto words = picks.words();
    const auto nx = static_cast<std::uint32_t>(nx_);
    const std::uint32_t biased = (0U - nx) % nx;  // Lemire (2019): words that would favour cells
    const auto cell_of = [&](std::uint32_t word) {
        std::uint64_t product = static_cast<std::uint64_t>(word) * nx;
        while (static_cast<std::uint32_t>(product) < biased)
            product = static_cast<std::uint64_t>(rest.next32()) * nx;
        return static_cast<int>(product >> 32);
    };
    const auto fetch = [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const int cell = cell_of(words[k]);
            __builtin_prefetch(row + cell, 1);
            cells[k % block] = cell;
        }
    };
    constexpr std::size_t ahead = block / 2;
    fetch(0, std::min(ahead, words.size()));
    for (std::size_t begin = 0; begin < words.size(); begin += ahead) {
        give_up_if_asked();
        const std::size_t end = std::min(begin + ahead, words.size());
        fetch(end, std::min(end + ahead, words.size()));
        for (std::size_t k = begin; k < end; ++k) hop(cells[k % block]);
    }
}

/// The commonest rule by itself: linear hops that carry q0.
template <bool truncate_terms, bool split>
void RowHops::hop_linearly(double* row, const Picks& picks) const {
    const double base = parameters_.hop_base;
    const double to_nearest = parameters_.landing == Landing::round ? 0.5 : 0.0;
    const double per_height = parameters_.hop_per_height;
    const double amount = parameters_.amount;
    const bool limited = parameters_.limit_amount;
    const bool shadowed = parameters_.shadow == Shadow::upwind_higher;
    const int nx = nx_;
    hop_from_each(row, picks, [=](int x) {
        const double height = row[x];
        double carried = limited && height < amount ? height : amount;
        carried = height > 0.0 ? carried : 0.0;
        if (shadowed) carried = row[x == 0 ? nx - 1 : x - 1] > height ? 0.0 : carried;
        double grown = per_height * height;
        if (truncate_terms) grown = static_cast<double>(static_cast<int>(usable(grown)));
        const double reach = usable(base + grown) + to_nearest;
        const int whole = static_cast<int>(reach);
        row[x] = height - carried;
        if (split) {
            const double far_amount = carried * (reach - static_cast<double>(whole));
            row[wrapped(x + whole, nx)] += carried - far_amount;
            row[wrapped(x + whole + 1, nx)] += far_amount;
        } else {
            row[wrapped(x + whole, nx)] += carried;
        }
    });
}

void RowHops::random_sequential(std::span<double> row, const Picks& picks) const {
    const SandParameters& p = parameters_;
    const bool common = p.hop_length == HopLength::linear && p.hop_amount == HopAmount::constant;
    if (!common) {
        hop_from_each(row.data(), picks, [&](int x) { hop_from(row.data(), x); });
    } else if (p.landing == Landing::truncate_terms) {
        hop_linearly<true, false>(row.data(), picks);
    } else if (p.landing == Landing::split) {
        hop_linearly<false, true>(row.data(), picks);
    } else {
        hop_linearly<false, false>(row.data(), picks);
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
        switch (p.slope_difference) {
            case SlopeDifference::central:
                slope = 0.5 * (right - left);
                break;
            case SlopeDifference::backward:
                slope = height - left;
                break;
            case SlopeDifference::forward:
                slope = right - height;
                break;
        }
    }
    double carried = p.amount;
    if (p.hop_amount == HopAmount::slope) {
        carried = std::max(0.0, p.amount + p.amount_slope_factor * elementary::tanh(slope));
    }
    if (p.limit_amount) carried = carried < height ? carried : height;
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
