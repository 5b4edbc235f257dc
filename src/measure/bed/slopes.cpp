#include "measure/bed/slopes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "measure/shared/undefined.h"

namespace fumon {

namespace {

constexpr double level = 1e-12;

std::vector<double> forward_differences(const Grid& bed, bool periodic) {
    if (bed.nx() < 2) return {};
    const auto nx = static_cast<std::size_t>(bed.nx());
    const std::size_t in_row = periodic ? nx : nx - 1;
    std::vector<double> differences(in_row * static_cast<std::size_t>(bed.ny()));
    for (int y = 0; y < bed.ny(); ++y) {
        const auto row = bed.row(y);
        double* difference = differences.data() + in_row * static_cast<std::size_t>(y);
        for (std::size_t x = 0; x + 1 < nx; ++x) difference[x] = row[x + 1] - row[x];
        if (periodic) difference[nx - 1] = row.front() - row.back();
    }
    return differences;
}

/// The same, but for those to or from a cell without data.
std::vector<double> known_differences(const Grid& bed, bool periodic, const Mask& nodata) {
    std::vector<double> differences;
    const int nx = bed.nx();
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < (periodic ? nx : nx - 1); ++x) {
            const int next = (x + 1) % nx;
            if (nodata(x, y) == 0 && nodata(next, y) == 0)
                differences.push_back(bed(next, y) - bed(x, y));
        }
    }
    return differences;
}

double skewness(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value;
    mean /= count;
    double second = 0.0;
    double third = 0.0;
    for (const double value : values) {
        const double square = (value - mean) * (value - mean);
        second += square;
        third += square * (value - mean);
    }
    second /= count;
    return third / count / (second * std::sqrt(second));
}

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return values.empty() ? undefined : sum / static_cast<double>(values.size());
}

/// The value that nine tenths of them do not exceed. Reorders them.
double ninetieth_percentile(std::span<double> values) {
    if (values.empty()) return undefined;
    const std::size_t rank = (values.size() * 9 + 9) / 10;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The magnitudes of rises and falls, without what is level, in one array with room between.
class Sides {
  public:
    Sides(std::span<const double> differences, double level_below)
        : magnitudes_(differences.size() + 1) {
        for (const double difference : differences) {  // without branches: noise has no pattern
            magnitudes_[rises_] = difference;
            magnitudes_[magnitudes_.size() - 1 - falls_] = -difference;
            rises_ += static_cast<std::size_t>(difference > level_below);
            falls_ += static_cast<std::size_t>(difference < -level_below);
        }
    }
    std::span<double> rises() { return std::span(magnitudes_).first(rises_); }
    std::span<double> falls() { return std::span(magnitudes_).last(falls_); }

  private:
    std::vector<double> magnitudes_;
    std::size_t rises_ = 0;
    std::size_t falls_ = 0;
};

}  // namespace

BedSlopes bed_slopes(const Grid& bed, bool periodic, const Mask& nodata) {
    const std::vector<double> differences = nodata.empty()
                                                ? forward_differences(bed, periodic)
                                                : known_differences(bed, periodic, nodata);
    double highest = 0.0;
    for (const double height : bed.values()) highest = std::max(highest, std::abs(height));
    Sides sides(differences, level * highest);
    BedSlopes result;
    if (sides.rises().empty() && sides.falls().empty()) return result;
    result.skewness = skewness(differences);
    result.stoss = mean_of(sides.rises());
    result.lee = mean_of(sides.falls());
    result.stoss_to_lee = result.stoss / result.lee;
    result.steep_stoss = ninetieth_percentile(sides.rises());
    result.steep_lee = ninetieth_percentile(sides.falls());
    return result;
}

}  // namespace fumon
