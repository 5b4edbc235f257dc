#include "measure/bed/crest_height.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "measure/bed/detrended_row.h"
#include "measure/bed/row_waves.h"
#include "measure/shared/undefined.h"

namespace fumon {

namespace {

/// Highest minus lowest of the sites first … last − 1, going round the row's end.
double relief(std::span<const double> heights, std::size_t first, std::size_t last) {
    double lowest = heights[first];
    double highest = heights[first];
    for (std::size_t x = first; x < last; ++x) {
        const double height = heights[x < heights.size() ? x : x - heights.size()];
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return highest - lowest;
}

}  // namespace

double top_one_percent_mean(const Grid& bed) {
    if (bed.empty()) return undefined;
    std::vector<double> heights(bed.values().begin(), bed.values().end());
    const std::size_t count = (heights.size() + 99) / 100;
    const auto end = heights.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(heights.begin(), end - 1, heights.end(), std::greater<>());
    std::sort(heights.begin(), end);
    double sum = 0.0;
    std::for_each(heights.begin(), end, [&](double height) { sum += height; });
    return sum / static_cast<double>(count);
}

double crest_to_trough_height(const Grid& bed, bool periodic) {
    const auto nx = static_cast<std::size_t>(bed.nx());
    std::vector<double> departures(nx);
    std::vector<int> sites;
    double sum = 0.0;
    std::int64_t waves = 0;
    for (int y = 0; y < bed.ny(); ++y) {
        detrend_row(bed.row(y), periodic, departures);
        find_upward_crossings(departures, periodic, sites);
        if (periodic && !sites.empty()) sites.push_back(sites.front() + bed.nx());
        for (std::size_t wave = 1; wave < sites.size(); ++wave) {
            sum += relief(departures, static_cast<std::size_t>(sites[wave - 1]),
                          static_cast<std::size_t>(sites[wave]));
            ++waves;
        }
    }
    return waves > 0 ? sum / static_cast<double>(waves) : undefined;
}

}  // namespace fumon
