#include "measure/bed/row_departures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

constexpr double rounding_of_departures = 1e-12;

}  // namespace

void row_departures(std::span<const double> row, bool periodic, std::span<double> departures) {
    const std::size_t nx = row.size();
    const auto count = static_cast<double>(nx);
    double mean = 0.0;
    for (const double h : row) mean += h;
    mean /= count;
    double slope = 0.0;
    const double middle = 0.5 * (count - 1.0);
    if (!periodic && nx > 1) {
        double moment = 0.0;
        for (std::size_t x = 0; x < nx; ++x) {
            moment += (static_cast<double>(x) - middle) * (row[x] - mean);
        }
        slope = 12.0 * moment / (count * (count * count - 1.0));
    }
    double largest = 0.0;
    double largest_departure = 0.0;
    for (std::size_t x = 0; x < nx; ++x) {
        departures[x] = row[x] - mean - slope * (static_cast<double>(x) - middle);
        largest = std::max(largest, std::abs(row[x]));
        largest_departure = std::max(largest_departure, std::abs(departures[x]));
    }
    if (largest_departure <= rounding_of_departures * largest) {
        std::fill(departures.begin(), departures.end(), 0.0);
    }
}

}  // namespace fumon
