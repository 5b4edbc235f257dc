#include "numerics/discrete_power_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "base/error.h"

namespace fumon {

namespace {

constexpr std::int64_t most_sizes = std::int64_t{1} << 22;  // a pile of 2048 × 2048 cells
constexpr double largest_exponent = 64.0;                   // no avalanches come near it

}  // namespace

void check_window(SizeWindow window) {
    if (window.low < 1 || window.low >= window.high)
        throw InputError(fmt::format(
            "a power law cannot be fitted to avalanche sizes {} to {}; the window starts at 1 or "
            "above and ends above its start",
            window.low, window.high));
    if (window.high - window.low >= most_sizes)
        throw InputError(fmt::format(
            "a power law cannot be fitted to avalanche sizes {} to {}; a window holds at most {} "
            "sizes",
            window.low, window.high, most_sizes));
}

DiscretePowerLaw::DiscretePowerLaw(SizeWindow window) {
    check_window(window);
    logs_.reserve(static_cast<std::size_t>(window.high - window.low + 1));
    const double first = elementary::log(static_cast<double>(window.low));
    for (std::int64_t size = window.low; size <= window.high; ++size)
        logs_.push_back(elementary::log(static_cast<double>(size)) - first);
}

/// s^−a up to a factor, scaled so that the largest is 1.
double DiscretePowerLaw::weight(std::size_t at, double exponent) const {
    return elementary::exp(-exponent * (exponent >= 0.0 ? logs_[at] : logs_[at] - logs_.back()));
}

DiscretePowerLaw::Moments DiscretePowerLaw::log_moments(double exponent) const {
    double total = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t at = 0; at < logs_.size(); ++at) {
        const double p = weight(at, exponent);
        total += p;
        first += p * logs_[at];
        second += p * logs_[at] * logs_[at];
    }
    const double mean = first / total;
    return {mean, second / total - mean * mean};
}

DiscretePowerLaw::Estimate DiscretePowerLaw::most_likely(std::span<const std::int64_t> counts,
                                                         double start) const {
    std::int64_t total = 0;
    double log_sum = 0.0;
    int different = 0;
    for (std::size_t at = 0; at < counts.size(); ++at) {
        total += counts[at];
        log_sum += static_cast<double>(counts[at]) * logs_[at];
        if (counts[at] > 0) ++different;
    }
    if (different < 2) return {};
    const double mean = log_sum / static_cast<double>(total);
    if (log_moments(-largest_exponent).mean <= mean || log_moments(largest_exponent).mean >= mean)
        return {};
    constexpr int most_steps = 200;
    constexpr double close = 1e-12;
    double low = -largest_exponent;
    double high = largest_exponent;
    double exponent = std::clamp(start, low, high);
    for (int step = 0; step < most_steps; ++step) {
        const Moments moments = log_moments(exponent);  // the mean falls as the exponent grows
        (moments.mean > mean ? low : high) = exponent;
        double next = exponent + (moments.mean - mean) / moments.variance;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const bool settled = std::abs(next - exponent) <= close * (1.0 + std::abs(exponent));
        exponent = next;
        if (settled) break;
    }
    return {exponent, log_moments(exponent).variance};
}

std::vector<double> DiscretePowerLaw::cumulative(double exponent) const {
    std::vector<double> cumulative(logs_.size());
    double sum = 0.0;
    for (std::size_t at = 0; at < logs_.size(); ++at) {
        sum += weight(at, exponent);
        cumulative[at] = sum;
    }
    for (double& value : cumulative) value /= sum;
    return cumulative;
}

void DiscretePowerLaw::draw(RandomStream& stream, std::int64_t sample,
                            std::span<const double> cumulative, std::span<std::int64_t> counts) {
    struct Part {
        std::size_t first, end;
        std::int64_t sample;
    };
    std::fill(counts.begin(), counts.end(), 0);
    std::vector<Part> parts{{0, counts.size(), sample}};
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        if (part.sample == 0) continue;
        if (part.end - part.first == 1) {
            counts[part.first] = part.sample;
            continue;
        }
        const std::size_t middle = part.first + (part.end - part.first) / 2;
        const double before = part.first == 0 ? 0.0 : cumulative[part.first - 1];
        const double whole = cumulative[part.end - 1] - before;
        const double left = cumulative[middle - 1] - before;
        const std::int64_t to_left =
            binomial(stream, part.sample, whole > 0.0 ? std::min(1.0, left / whole) : 1.0);
        parts.push_back({middle, part.end, part.sample - to_left});
        parts.push_back({part.first, middle, to_left});
    }
}

double largest_distance(std::span<const std::int64_t> counts, std::span<const double> cumulative) {
    const std::int64_t total = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    if (total == 0) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    std::int64_t up_to_here = 0;
    for (std::size_t at = 0; at < counts.size(); ++at) {
        up_to_here += counts[at];
        const double counted = static_cast<double>(up_to_here) / static_cast<double>(total);
        largest = std::max(largest, std::abs(counted - cumulative[at]));
    }
    return largest;
}

}  // namespace fumon
