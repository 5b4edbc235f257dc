#include "measure/slopes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace fumon {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double level = 1e-12;

std::vector<double> forward_differences(const Grid& bed, bool periodic) {
    std::vector<double> differences;
    differences.reserve(bed.size());
    for (int y = 0; y < bed.ny(); ++y) {
        const auto row = bed.row(y);
        for (std::size_t x = 0; x + 1 < row.size(); ++x) {
            differences.push_back(row[x + 1] - row[x]);
        }
        if (periodic && row.size() > 1) differences.push_back(row.front() - row.back());
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

}  // namespace

BedSlopes bed_slopes(const Grid& bed, bool periodic) {
    const std::vector<double> differences = forward_differences(bed, periodic);
    double highest = 0.0;
    for (const double height : bed.values()) highest = std::max(highest, std::abs(height));
    std::vector<double> rises;
    std::vector<double> falls;
    for (const double difference : differences) {
        if (difference > level * highest) rises.push_back(difference);
        if (difference < -level * highest) falls.push_back(-difference);
    }
    BedSlopes result;
    if (rises.empty() && falls.empty()) return result;
    result.skewness = skewness(differences);
    result.stoss = mean_of(rises);
    result.lee = mean_of(falls);
    result.stoss_to_lee = result.stoss / result.lee;
    result.steep_stoss = ninetieth_percentile(rises);
    result.steep_lee = ninetieth_percentile(falls);
    return result;
}

}  // namespace fumon
