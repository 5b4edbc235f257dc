#include "measure/pile/power_law.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "base/random.h"

namespace fumon {

namespace {

/// One count a size of the window.
std::vector<std::int64_t> counts_in(const AvalancheSizes& sizes, SizeWindow window) {
    std::vector<std::int64_t> counts(static_cast<std::size_t>(window.high - window.low + 1));
    for (const SizeBin& bin : sizes.bins()) {
        if (bin.size >= window.low && bin.size <= window.high)
            counts[static_cast<std::size_t>(bin.size - window.low)] = bin.count;
    }
    return counts;
}

LikelihoodFit fit_counts(const DiscretePowerLaw& law, const std::vector<std::int64_t>& counts) {
    LikelihoodFit fit;
    fit.avalanches = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    const auto estimate = law.most_likely(counts);
    if (std::isnan(estimate.exponent)) return fit;
    fit.exponent = estimate.exponent;
    fit.standard_error =
        1.0 / std::sqrt(static_cast<double>(fit.avalanches) * estimate.log_variance);
    fit.distance = largest_distance(counts, law.cumulative(fit.exponent));
    return fit;
}

}  // namespace

LineFit fit_raw_bins(const AvalancheSizes& sizes, SizeWindow window) {
    check_window(window);
    std::vector<double> size;
    std::vector<double> share;
    for (const SizeBin& bin : sizes.bins()) {
        if (bin.size < window.low || bin.size > window.high) continue;
        size.push_back(static_cast<double>(bin.size));
        share.push_back(bin.share);
    }
    return fit_line_in_logarithms(size, share);
}

LineFit fit_logarithmic_bins(const AvalancheSizes& sizes, SizeWindow window, int bins_per_decade) {
    check_window(window);
    std::vector<double> size;
    std::vector<double> density;
    for (const LogarithmicBin& bin : sizes.logarithmic_bins(bins_per_decade)) {
        if (bin.low < window.low || bin.high > window.high || bin.count == 0) continue;
        size.push_back(bin.size);
        density.push_back(bin.density);
    }
    return fit_line_in_logarithms(size, density);
}

LikelihoodFit fit_likelihood(const AvalancheSizes& sizes, SizeWindow window) {
    const DiscretePowerLaw law(window);
    return fit_counts(law, counts_in(sizes, window));
}

double power_law_probability(const AvalancheSizes& sizes, SizeWindow window, int resamples) {
    if (resamples < 1) throw Error(fmt::format("{} resamples; at least 1 is needed", resamples));
    const DiscretePowerLaw law(window);
    std::vector<std::int64_t> counts = counts_in(sizes, window);
    const LikelihoodFit fit = fit_counts(law, counts);
    if (std::isnan(fit.exponent)) return LikelihoodFit::none;
    const std::vector<double> cumulative = law.cumulative(fit.exponent);
    int as_far = 0;
    for (int resample = 0; resample < resamples; ++resample) {
        RandomStream stream(bootstrap_seed, static_cast<std::uint32_t>(resample), 0,
                            Purpose::bootstrap);
        DiscretePowerLaw::draw(stream, fit.avalanches, cumulative, counts);
        const double exponent = law.most_likely(counts, fit.exponent).exponent;
        // A sample of one size is fitted exactly in the limit of infinite exponents: distance 0.
        if (std::isnan(exponent)) continue;
        if (largest_distance(counts, law.cumulative(exponent)) >= fit.distance) ++as_far;
    }
    return static_cast<double>(as_far) / resamples;
}

SizeWindow best_window(const AvalancheSizes& sizes, std::int64_t high, std::int64_t fewest) {
    constexpr std::int64_t decade = 10;
    check_window({1, high});
    SizeWindow best{0, high};
    double nearest = std::numeric_limits<double>::infinity();
    for (const SizeBin& bin : sizes.bins()) {
        const SizeWindow window{bin.size, high};
        if (bin.size > high / decade) break;
        const LikelihoodFit fit = fit_likelihood(sizes, window);
        if (fit.avalanches < fewest) break;
        if (fit.distance < nearest) {
            nearest = fit.distance;
            best = window;
        }
    }
    if (best.low == 0)
        throw InputError(fmt::format(
            "no window of avalanche sizes up to {} spans a decade and holds {} avalanches; take "
            "more grains or a larger end",
            high, fewest));
    return best;
}

}  // namespace fumon
