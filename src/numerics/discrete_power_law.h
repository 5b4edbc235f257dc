#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/random.h"

namespace fumon {

/// Sizes low … high, both included.
struct SizeWindow {
    std::int64_t low = 10;
    std::int64_t high = 100;
};

/// Throws InputError unless 1 ≤ low < high and the window holds at most 2^22 sizes.
void check_window(SizeWindow window);

/// The power law on whole numbers of a window: p(s) = s^−a / Σ t^−a, t = low … high; the sum is
/// finite, so that a may be any number. `counts` hold one value a size, from low on.
class DiscretePowerLaw {
  public:
    /// Throws InputError as `check_window` does.
    explicit DiscretePowerLaw(SizeWindow window);

    [[nodiscard]] std::size_t sizes() const { return logs_.size(); }

    struct Estimate {
        double exponent = std::numeric_limits<double>::quiet_NaN();
        double log_variance = std::numeric_limits<double>::quiet_NaN();  ///< of ln s under p
    };

    /// The exponent of largest likelihood: the one root of E[ln s] = mean of ln s over the counts,
    /// by Newton's method kept in a shrinking bracket. `start` is a first guess and changes the
    /// result by rounding only. Not a number without counts, with counts of one size only, and
    /// beyond ±64.
    [[nodiscard]] Estimate most_likely(std::span<const std::int64_t> counts,
                                       double start = 1.5) const;

    /// P(size ≤ s) for every size of the window; the last is 1.
    [[nodiscard]] std::vector<double> cumulative(double exponent) const;

    /// A sample of so many sizes from the law with this cumulative distribution, as counts: an
    /// exact multinomial, made by halving the window with binomials.
    static void draw(RandomStream& stream, std::int64_t sample, std::span<const double> cumulative,
                     std::span<std::int64_t> counts);

  private:
    struct Moments {
        double mean = 0.0;
        double variance = 0.0;
    };
    [[nodiscard]] Moments log_moments(double exponent) const;
    [[nodiscard]] double weight(std::size_t at, double exponent) const;

    std::vector<double> logs_;  ///< ln(size / low)
};

/// The Kolmogorov–Smirnov distance: the largest |P_counted(size ≤ s) − P(size ≤ s)|. Not a number
/// without counts.
double largest_distance(std::span<const std::int64_t> counts, std::span<const double> cumulative);

}  // namespace fumon
