#pragma once

#include <cstdint>
#include <limits>

#include "measure/pile/avalanche_sizes.h"
#include "numerics/discrete_power_law.h"
#include "numerics/line_fit.h"

namespace fumon {

/// Whether avalanche sizes follow a power law over a window of sizes, p(s) ∝ s^−a, and with which
/// exponent, three ways. All of them throw InputError unless 1 ≤ low < high, and for windows of
/// more than 2^22 sizes; all of them see the sizes in the window only (shares stay those of all
/// avalanches). None of them knows that avalanches follow one another: where these are correlated
/// in time, standard errors are too small and so are probabilities.

/// Least squares of log A_p over log A_s, whose slope is −a, one point for every size that came
/// (Higashi & Takamori 2003, section 4.3.3 and figure 15, whose window is 10 … 100).
///
/// Biased where counts are small: sizes that never came have no logarithm and are left out, and a
/// size that came once weighs as much as one that came a thousand times, so the tail bends up and
/// the slope comes out too shallow. The standard error takes all points as equally good, which they
/// are not. A high R² is no evidence of a power law: other steep laws have one too.
LineFit fit_raw_bins(const AvalancheSizes& sizes, SizeWindow window = {});

/// The same through logarithmic bins: density over geometric mean of those bins that lie wholly in
/// the window and are not empty. Far less biased, but the bins still weigh the same, the geometric
/// mean is the right place only near a = 2, narrow first bins hold few sizes, and a window that is
/// no whole number of bins loses its ends. Throws Error unless 1 ≤ bins_per_decade ≤ 100.
LineFit fit_logarithmic_bins(const AvalancheSizes& sizes, SizeWindow window = {},
                             int bins_per_decade = 8);

/// The discrete power law truncated to the window, by largest likelihood.
struct LikelihoodFit {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double exponent = none;        ///< a
    double standard_error = none;  ///< 1 / √(n · variance of ln s under the law) (Fisher)
    double distance = none;  ///< Kolmogorov–Smirnov, between counted and fitted P(size ≤ s)
    std::int64_t avalanches = 0;  ///< n, in the window
};

/// The exponent that makes the avalanches in the window most likely (as Clauset, Shalizi & Newman
/// 2009, appendix B.3, but with the finite normalising sum of the window). The best of the three
/// where the law holds, and always an answer where it does not: see `power_law_probability`. Not a
/// number where fewer than two sizes came, or for exponents beyond ±64.
LikelihoodFit fit_likelihood(const AvalancheSizes& sizes, SizeWindow window = {});

/// How likely samples of the fitted power law, each fitted anew, lie as far from their fit as the
/// avalanches from theirs (Kolmogorov–Smirnov distance; Clauset, Shalizi & Newman 2009, section
/// 4.1): below .1 the power law is to be doubted. `resamples` are drawn from
/// RandomStream(bootstrap_seed, resample, 0, Purpose::bootstrap): the same avalanches give the same
/// probability; its own standard error is at most 0.5 / √resamples.
///
/// Says nothing for few avalanches (anything passes), and turns down the smallest departure for
/// very many (a model's avalanches are a power law only nearly). Too high where the window itself
/// was chosen for its fit. Not a number where the fit is not; throws Error for resamples < 1.
double power_law_probability(const AvalancheSizes& sizes, SizeWindow window = {},
                             int resamples = 200);

inline constexpr std::uint64_t bootstrap_seed = 2009;

/// The window up to `high` from where on the power law fits best: the low end, out of the sizes
/// that came, with the smallest Kolmogorov–Smirnov distance (Clauset, Shalizi & Newman 2009,
/// section 3.3), the smaller of two equals. At least a decade and `fewest` avalanches stay in the
/// window, as any law fits a short or empty one. Throws InputError where no low end leaves as much,
/// or high − 1 exceeds 2^22. Takes as many fits as there are low ends to try.
SizeWindow best_window(const AvalancheSizes& sizes, std::int64_t high, std::int64_t fewest = 100);

}  // namespace fumon
