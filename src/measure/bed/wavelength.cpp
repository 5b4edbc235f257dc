#include "measure/bed/wavelength.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "measure/shared/undefined.h"
#include "numerics/peak_offset.h"

namespace fumon {

namespace {

constexpr int bins_beside_peak = 2;
constexpr int least_columns = 4;

}  // namespace

double wavelength_of_spectrum(const RowPower& of_rows, int nx) {
    const std::vector<double>& power = of_rows.windowed;
    if (nx < least_columns || power.empty()) return undefined;
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
    return weighted > 0.0 ? nx * total / weighted : undefined;
}

double wavelength_of_autocorrelation(const RowPower& of_rows, int nx, bool periodic) {
    if (nx < least_columns) return undefined;
    std::vector<double> correlation =
        autocorrelation(of_rows, static_cast<std::size_t>(nx), periodic);
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

double wavelength_of_crossings(const BedWaves& waves, int nx) {
    if (nx < least_columns || waves.count == 0) return undefined;
    return static_cast<double>(waves.length) / static_cast<double>(waves.count);
}

double wavelength_spectrum(const Grid& bed, bool periodic) {
    return wavelength_of_spectrum(power_of_rows(bed, periodic), bed.nx());
}

double wavelength_autocorrelation(const Grid& bed, bool periodic) {
    return wavelength_of_autocorrelation(power_of_rows(bed, periodic), bed.nx(), periodic);
}

double wavelength_crossings(const Grid& bed, bool periodic) {
    return wavelength_of_crossings(bed_waves(bed, periodic), bed.nx());
}

}  // namespace fumon
