#include "measure/wavelength.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/error.h"
#include "terrain/elementary.h"

namespace fumon {

namespace {

constexpr int bins_beside_peak = 2;
constexpr double turn = 6.283185307179586;

/// Power in wave numbers 0 … nx/2, summed over the rows, by the plain sum of the Fourier transform.
std::vector<double> power_along_x(const Grid& bed) {
    const auto nx = static_cast<std::size_t>(bed.nx());
    std::vector<double> cosine(nx);
    std::vector<double> sine(nx);
    for (std::size_t i = 0; i < nx; ++i) {
        const double angle = turn * static_cast<double>(i) / static_cast<double>(nx);
        cosine[i] = elementary::cos(angle);
        sine[i] = elementary::sin(angle);
    }
    std::vector<double> power(nx / 2 + 1);
    for (int y = 0; y < bed.ny(); ++y) {
        const auto row = bed.row(y);
        double mean = 0.0;
        for (const double h : row) mean += h;
        mean /= static_cast<double>(nx);
        for (std::size_t k = 1; k < power.size(); ++k) {
            double real = 0.0;
            double imaginary = 0.0;
            std::size_t phase = 0;
            for (const double h : row) {
                real += (h - mean) * cosine[phase];
                imaginary += (h - mean) * sine[phase];
                phase += k;
                if (phase >= nx) phase -= nx;
            }
            power[k] += real * real + imaginary * imaginary;
        }
    }
    return power;
}

}  // namespace

double wavelength_along_x(const Grid& bed) {
    if (bed.nx() < 4) throw Error("a wavelength along x needs at least 4 columns");
    const std::vector<double> power = power_along_x(bed);
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
    return weighted > 0.0 ? bed.nx() * total / weighted : 0.0;
}

}  // namespace fumon
