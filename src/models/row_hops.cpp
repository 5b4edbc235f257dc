#include "models/row_hops.h"

#include <algorithm>
#include <cmath>

#include "support/multiversion.h"
#include "terrain/elementary.h"
#include "terrain/random.h"

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

FUMON_MULTIVERSION void tanh_of_differences(const double* left, const double* right, double factor,
                                            int count, double* out) {
    for (int x = 0; x < count; ++x) out[x] = elementary::tanh(factor * (right[x] - left[x]));
}

FUMON_MULTIVERSION void linear(const double* in, double base, double factor, int count,
                               double* out) {
    for (int x = 0; x < count; ++x) out[x] = usable(base + factor * in[x]);
}

FUMON_MULTIVERSION void linear_truncated(const double* in, double base, double factor, int count,
                                         double* out) {
    for (int x = 0; x < count; ++x) {
        out[x] = usable(base + static_cast<double>(static_cast<int>(usable(factor * in[x]))));
    }
}

FUMON_MULTIVERSION void exponential(const double* in, double scale, double rate, int count,
                                    double* out) {
    for (int x = 0; x < count; ++x) out[x] = usable(scale * (elementary::exp(rate * in[x]) - 1.0));
}

FUMON_MULTIVERSION void constant_amounts(const double* height, double amount, int count,
                                         double* out) {
    for (int x = 0; x < count; ++x) {
        const double there = height[x] > 0.0 ? height[x] : 0.0;
        out[x] = amount < there ? amount : there;
    }
}

FUMON_MULTIVERSION void slope_amounts(const double* height, const double* slope_tanh, double base,
                                      double factor, double limited, int count, double* out) {
    for (int x = 0; x < count; ++x) {
        const double wanted = base + factor * slope_tanh[x];
        const double carried = wanted > 0.0 ? wanted : 0.0;
        const double there = height[x] > 0.0 ? height[x] : 0.0;
        const double most = limited != 0.0 ? there : carried;
        out[x] = carried < most ? carried : most;
    }
}

FUMON_MULTIVERSION void subtract(const double* from, const double* what, int count, double* out) {
    for (int x = 0; x < count; ++x) out[x] = from[x] - what[x];
}

FUMON_MULTIVERSION void add_to_all(double* values, double what, int count) {
    for (int x = 0; x < count; ++x) values[x] += what;
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
                   parameters.hop_amount == HopAmount::slope),
      slope_tanh_(static_cast<std::size_t>(nx)),
      length_(static_cast<std::size_t>(nx)),
      amount_(static_cast<std::size_t>(nx)) {}

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
    }
    return 0.0;
}

void RowHops::synchronous(std::span<const double> before, std::span<double> after) {
    if (needs_slope_) take_slopes(before);
    take_lengths(before);
    take_amounts(before);
    subtract(before.data(), amount_.data(), nx_, after.data());
    if (parameters_.landing == Landing::split) {
        land_split(after);
    } else {
        land(after);
    }
}

void RowHops::take_slopes(std::span<const double> before) {
    const double* h = before.data();
    double* out = slope_tanh_.data();
    const int last = nx_ - 1;
    const auto edge = [&](int x, double left, double right, double factor) {
        out[x] = elementary::tanh(factor * (right - left));
    };
    switch (parameters_.slope_difference) {
        case SlopeDifference::central:
            if (nx_ > 2) tanh_of_differences(h, h + 2, 0.5, nx_ - 2, out + 1);
            edge(0, h[last], h[1 % nx_], 0.5);
            edge(last, h[(last + nx_ - 1) % nx_], h[0], 0.5);
            break;
        case SlopeDifference::backward:
            tanh_of_differences(h, h + 1, 1.0, last, out + 1);
            edge(0, h[last], h[0], 1.0);
            break;
        case SlopeDifference::forward:
            tanh_of_differences(h, h + 1, 1.0, last, out);
            edge(last, h[last], h[0], 1.0);
            break;
    }
}

void RowHops::take_lengths(std::span<const double> before) {
    const SandParameters& p = parameters_;
    switch (p.hop_length) {
        case HopLength::linear:
            if (p.landing == Landing::truncate_terms) {
                linear_truncated(before.data(), p.hop_base, p.hop_per_height, nx_, length_.data());
            } else {
                linear(before.data(), p.hop_base, p.hop_per_height, nx_, length_.data());
            }
            break;
        case HopLength::slope:
            linear(slope_tanh_.data(), p.hop_base, -p.hop_slope_factor, nx_, length_.data());
            break;
        case HopLength::exponential:
            exponential(before.data(), exponential_scale_, exponential_rate_, nx_, length_.data());
            break;
    }
    if (p.landing == Landing::round) add_to_all(length_.data(), 0.5, nx_);
}

void RowHops::take_amounts(std::span<const double> before) {
    const SandParameters& p = parameters_;
    if (p.hop_amount == HopAmount::slope) {
        slope_amounts(before.data(), slope_tanh_.data(), p.amount, p.amount_slope_factor,
                      p.limit_amount ? 1.0 : 0.0, nx_, amount_.data());
    } else if (p.limit_amount) {
        constant_amounts(before.data(), p.amount, nx_, amount_.data());
    } else {
        std::fill(amount_.begin(), amount_.end(), p.amount);
    }
    if (p.shadow == Shadow::none) return;
    for (int x = 0; x < nx_; ++x) {
        const auto here = static_cast<std::size_t>(x);
        const double upwind = before[x == 0 ? before.size() - 1 : here - 1];
        if (upwind > before[here]) amount_[here] = 0.0;
    }
}

void RowHops::land(std::span<double> after) const {
    double* row = after.data();
    for (int x = 0; x < nx_; ++x) {
        const auto here = static_cast<std::size_t>(x);
        row[wrapped(x + static_cast<int>(length_[here]), nx_)] += amount_[here];
    }
}

void RowHops::land_split(std::span<double> after) const {
    double* row = after.data();
    for (int x = 0; x < nx_; ++x) {
        const auto here = static_cast<std::size_t>(x);
        const int whole = static_cast<int>(length_[here]);
        const double far_share = length_[here] - static_cast<double>(whole);
        const double far_amount = amount_[here] * far_share;
        row[wrapped(x + whole, nx_)] += amount_[here] - far_amount;
        row[wrapped(x + whole + 1, nx_)] += far_amount;
    }
}

void RowHops::random_sequential(std::span<double> row, std::int64_t picks, std::uint64_t seed,
                                std::uint32_t row_number, std::int64_t step) {
    RandomStream stream(seed, row_number, step, Purpose::picks);
    words_.resize(static_cast<std::size_t>(picks));
    stream.fill(words_);
    const auto cells = static_cast<std::uint32_t>(nx_);
    const std::uint32_t biased =
        (0U - cells) % cells;  // Lemire (2019): words that would favour some cells
    for (std::uint32_t word : words_) {
        std::uint64_t product = static_cast<std::uint64_t>(word) * cells;
        while (static_cast<std::uint32_t>(product) < biased) {
            word = stream.next32();
            product = static_cast<std::uint64_t>(word) * cells;
        }
        hop_from(row.data(), static_cast<int>(product >> 32));
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
