#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fumon {

/// The value at a share of sorted values, linear between neighbours: that at place share × (n − 1)
/// (rule 7 of Hyndman & Fan 1996, "Sample quantiles in statistical packages"; NumPy's default).
/// There is at least one value.
double quantile(std::span<const double> sorted, double share);

/// What a box plot shows of some values (Tukey 1977, "Exploratory data analysis").
struct BoxStatistics {
    std::int64_t count = 0;
    double mean = 0.0;
    double lower_quartile = 0.0;  ///< quantile() at 1/4
    double median = 0.0;
    double upper_quartile = 0.0;
    double lower_whisker = 0.0;  ///< the least value within 1.5 interquartile ranges of the box
    double upper_whisker = 0.0;
    std::vector<double> beyond;  ///< values outside of the whiskers, sorted
};

/// Of at least one value, all finite.
BoxStatistics box_statistics(std::vector<double> values);

/// A density along values: `density[i]` at `value[i]`.
struct DensityCurve {
    std::vector<double> value;
    std::vector<double> density;
};

/// The density of values as a sum of normal distributions whose width is the sample's standard
/// deviation times n^(−1/5) (Scott 1992, "Multivariate density estimation"), at `samples` places
/// from the least to the greatest value. Empty where all are equal.
DensityCurve gaussian_density(std::span<const double> values, int samples = 100);

/// Ends of the bins of a histogram of values, count + 1 of them.
struct BinSettings {
    std::int64_t count =
        0;              ///< 0: the more of Sturges's and Freedman & Diaconis's (NumPy's "auto")
    double low = 0.0;   ///< the first bin begins there
    double high = 1.0;  ///< the last ends there
    bool logarithmic = false;  ///< as wide as each other in the logarithms
};
std::vector<double> bin_edges(std::span<const double> values, const BinSettings& settings);

/// How many values lie in each bin, of which the last alone has its upper end.
std::vector<std::int64_t> bin_counts(std::span<const double> values, std::span<const double> edges);

}  // namespace fumon
