#include "measure/bed/detrended_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

constexpr double detrended_rounding = 1e-12;

/// The largest magnitude, found in several lanes side by side.
double largest_of(std::span<const double> values) {
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> largest{};
    std::size_t x = 0;
    for (; x + lanes <= values.size(); x += lanes) {
        for (std::size_t k = 0; k < lanes; ++k)
            largest[k] = std::max(largest[k], std::abs(values[x + k]));
    }
    for (; x < values.size(); ++x) largest[0] = std::max(largest[0], std::abs(values[x]));
    return std::ranges::max(largest);
}

}  // namespace

std::array<double, most_row_means> row_means(const Grid& bed, int first, int count) {
    std::array<double, most_row_means> means{};
    std::array<const double*, most_row_means> rows{};
    for (std::size_t k = 0; k < most_row_means; ++k)
        rows[k] = bed.row(first + std::min(static_cast<int>(k), count - 1)).data();
    const auto nx = static_cast<std::size_t>(bed.nx());
    for (std::size_t x = 0; x < nx; ++x) {
        for (std::size_t k = 0; k < most_row_means; ++k) means[k] += rows[k][x];
    }
    for (double& mean : means) mean /= static_cast<double>(nx);
    return means;
}

void detrend_row(std::span<const double> row, bool periodic, std::span<double> departures) {
    double mean = 0.0;
    for (const double h : row) mean += h;
    detrend_row(row, mean / static_cast<double>(row.size()), periodic, departures);
}

void detrend_row(std::span<const double> row, double mean, bool periodic,
                 std::span<double> departures) {
    const std::size_t nx = row.size();
    const auto count = static_cast<double>(nx);
    double slope = 0.0;
    const double middle = 0.5 * (count - 1.0);
    if (!periodic && nx > 1) {
        double moment = 0.0;
        for (std::size_t x = 0; x < nx; ++x) {
            moment += (static_cast<double>(x) - middle) * (row[x] - mean);
        }
        slope = 12.0 * moment / (count * (count * count - 1.0));
    }
    for (std::size_t x = 0; x < nx; ++x)
        departures[x] = row[x] - mean - slope * (static_cast<double>(x) - middle);
    const double largest = largest_of(row);
    const double largest_departure = largest_of(departures);
    if (largest_departure <= detrended_rounding * largest) {
        std::fill(departures.begin(), departures.end(), 0.0);
    }
}

}  // namespace fumon
