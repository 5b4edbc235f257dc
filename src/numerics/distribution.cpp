#include "numerics/distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/elementary_power.h"

namespace fumon {

namespace {

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// The bins of NumPy's "auto" between the least and greatest of `values`: those of Freedman &
/// Diaconis (1981), or of Sturges (1926) where these are wider or there is no quartile's range.
std::int64_t automatic_bins(std::vector<double> values) {
    constexpr std::int64_t most = 1000;
    std::sort(values.begin(), values.end());
    const double range = values.back() - values.front();
    if (!(range > 0.0)) return 1;
    const auto count = static_cast<double>(values.size());
    const double sturges = range / (elementary::log(count) / elementary::log(2.0) + 1.0);
    const double quartiles = quantile(values, 0.75) - quantile(values, 0.25);
    const double freedman = 2.0 * quartiles * elementary::pow(count, -1.0 / 3.0);
    const double width = freedman > 0.0 ? std::min(freedman, sturges) : sturges;
    constexpr double rounding = 1e-9;
    const double bins = std::ceil(range / width - rounding);
    return bins < static_cast<double>(most) ? std::max<std::int64_t>(1, std::llround(bins)) : most;
}

}  // namespace

double quantile(std::span<const double> sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

BoxStatistics box_statistics(std::vector<double> values) {
    constexpr double reach = 1.5;  // of the quartiles' range
    std::sort(values.begin(), values.end());
    BoxStatistics box;
    box.count = static_cast<std::int64_t>(values.size());
    box.mean = mean_of(values);
    box.lower_quartile = quantile(values, 0.25);
    box.median = quantile(values, 0.5);
    box.upper_quartile = quantile(values, 0.75);
    const double range = box.upper_quartile - box.lower_quartile;
    const double low = box.lower_quartile - reach * range;
    const double high = box.upper_quartile + reach * range;
    box.lower_whisker = box.lower_quartile;
    box.upper_whisker = box.upper_quartile;
    for (const double value : values) {
        if (value < low || value > high) {
            box.beyond.push_back(value);
            continue;
        }
        box.lower_whisker = std::min(box.lower_whisker, value);
        box.upper_whisker = std::max(box.upper_whisker, value);
    }
    return box;
}

DensityCurve gaussian_density(std::span<const double> values, int samples) {
    DensityCurve curve;
    if (values.size() < 2) return curve;
    const auto [least, greatest] = std::ranges::minmax(values);
    if (!(greatest > least)) return curve;
    const auto count = static_cast<double>(values.size());
    const double mean = mean_of(values);
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double width = std::sqrt(squares / (count - 1.0)) * elementary::pow(count, -0.2);
    constexpr double root_of_two_pi = 2.50662827463100050242;
    for (int i = 0; i < samples; ++i) {
        const double at = std::lerp(least, greatest, static_cast<double>(i) / (samples - 1));
        double sum = 0.0;
        for (const double value : values) {
            const double away = (at - value) / width;
            sum += elementary::exp(-0.5 * away * away);
        }
        curve.value.push_back(at);
        curve.density.push_back(sum / (count * width * root_of_two_pi));
    }
    return curve;
}

std::vector<double> bin_edges(std::span<const double> values, const BinSettings& settings) {
    double low = settings.low;
    double high = settings.high;
    std::vector<double> counted;
    for (const double value : values) {
        if (value >= low && value <= high)
            counted.push_back(settings.logarithmic ? elementary::log10(value) : value);
    }
    std::int64_t count = settings.count;
    if (count == 0) count = counted.empty() ? 1 : automatic_bins(counted);
    if (!(high > low)) {
        low = settings.logarithmic ? 0.5 * low : low - 0.5;
        high = settings.logarithmic ? 2.0 * high : high + 0.5;
    }
    std::vector<double> edges;
    const auto bins = static_cast<double>(count);
    for (std::int64_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(i);
        edges.push_back(settings.logarithmic ? low * elementary::pow(high / low, number / bins)
                                             : number * ((high - low) / bins) + low);
    }
    edges.push_back(high);
    return edges;
}

std::vector<std::int64_t> bin_counts(std::span<const double> values,
                                     std::span<const double> edges) {
    std::vector<std::int64_t> counts(edges.size() - 1, 0);
    for (const double value : values) {
        if (!(value >= edges.front() && value <= edges.back())) continue;
        const auto above = std::upper_bound(edges.begin(), edges.end(), value) - edges.begin();
        const auto bin = std::min<std::ptrdiff_t>(above - 1, std::ssize(counts) - 1);
        ++counts[static_cast<std::size_t>(bin)];
    }
    return counts;
}

}  // namespace fumon
