#include "measure/bed/wavelength.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "measure/bed/detrended_row.h"
#include "measure/bed/row_spectrum.h"
#include "measure/bed/row_waves.h"
#include "measure/shared/undefined.h"
#include "numerics/peak_offset.h"

namespace fumon {

namespace {

constexpr int bins_beside_peak = 2;
constexpr int least_columns = 4;

}  // namespace

double wavelength_spectrum(const Grid& bed, bool periodic) {
    if (bed.nx() < least_columns || bed.empty()) return undefined;
    const std::vector<double> power = power_along_x(bed, periodic);
    const auto peak =
        static_cast<int>(std::max_element(power.begin() + 1, power.end()) - power.begin());
    const int first = std::max(1, peak - bins_beside_peak);
    const int last = std::min(static_cast<int>(power.size()) - 1, peak + bins_beside_peak);
    double total = 0.0;
    double weighted = 0.0;
    for (int k = first; k <= last; ++k) {
        total += power[static_cast<std::size_t>(k)];
        weighted += k * power[static_cast<std::size_t>(k)];
    }
    return weighted > 0.0 ? bed.nx() * total / weighted : undefined;
}

double wavelength_autocorrelation(const Grid& bed, bool periodic) {
    if (bed.nx() < least_columns || bed.empty()) return undefined;
    std::vector<double> correlation = autocorrelation_along_x(bed, periodic);
    if (correlation.empty()) return undefined;
    if (periodic) {
        const double first = correlation[0];
        const double second = correlation[1];
        correlation.push_back(first);
        correlation.push_back(second);
    }
    const auto negative = [](double value) { return value < 0.0; };
    const auto positive = [](double value) { return value > 0.0; };
    const auto trough = std::find_if(correlation.begin(), correlation.end(), negative);
    const auto rise = std::find_if(trough, correlation.end(), positive);
    const auto fall = std::find_if(rise, correlation.end(), negative);
    if (rise == correlation.end()) return undefined;
    const auto peak = std::max_element(rise, fall);
    if (peak + 1 == correlation.end()) return undefined;
    return static_cast<double>(peak - correlation.begin()) +
           peak_offset(*(peak - 1), *peak, *(peak + 1));
}

double wavelength_crossings(const Grid& bed, bool periodic) {
    if (bed.nx() < least_columns || bed.empty()) return undefined;
    std::vector<double> departures(static_cast<std::size_t>(bed.nx()));
    std::vector<int> sites;
    std::int64_t length = 0;
    std::int64_t waves = 0;
    for (int y = 0; y < bed.ny(); ++y) {
        detrend_row(bed.row(y), periodic, departures);
        find_upward_crossings(departures, periodic, sites);
        if (periodic) {
            length += bed.nx();
            waves += static_cast<std::int64_t>(sites.size());
        } else if (sites.size() > 1) {
            length += sites.back() - sites.front();
            waves += static_cast<std::int64_t>(sites.size()) - 1;
        }
    }
    return waves > 0 ? static_cast<double>(length) / static_cast<double>(waves) : undefined;
}

}  // namespace fumon
