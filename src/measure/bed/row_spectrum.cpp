#include "measure/bed/row_spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>

#include "base/elementary.h"
#include "base/error.h"
#include "measure/bed/row_departures.h"
#include "numerics/fourier_transform.h"

namespace fumon {

namespace {

using Complex = std::complex<double>;

constexpr double turn = 6.283185307179586;

std::vector<double> hann_window(std::size_t length) {
    std::vector<double> window(length);
    for (std::size_t x = 0; x < length; ++x) {
        window[x] = 0.5 - 0.5 * elementary::cos(turn * (static_cast<double>(x) + 0.5) /
                                                static_cast<double>(length));
    }
    return window;
}

/// Transforms real rows two at a time, as the real and imaginary parts of one complex row of
/// `length` sites (those past nx are zero).
class RowPairs {
  public:
    RowPairs(std::size_t nx, std::size_t length)
        : transform_(length), departures_(nx), pair_(length), spectrum_(length) {}

    void clear() { std::fill(pair_.begin(), pair_.end(), Complex()); }
    void set_real(std::span<const double> row, bool periodic, std::span<const double> window = {}) {
        find_departures(row, periodic, window);
        for (std::size_t x = 0; x < departures_.size(); ++x) pair_[x].real(departures_[x]);
    }
    void set_imaginary(std::span<const double> row, bool periodic,
                       std::span<const double> window = {}) {
        find_departures(row, periodic, window);
        for (std::size_t x = 0; x < departures_.size(); ++x) pair_[x].imag(departures_[x]);
    }
    /// Σ f² of the row that was set last.
    [[nodiscard]] double squares() const {
        double sum = 0.0;
        for (const double departure : departures_) sum += departure * departure;
        return sum;
    }
    const std::vector<Complex>& transformed() {
        transform_.forward(pair_, spectrum_);
        return spectrum_;
    }

  private:
    void find_departures(std::span<const double> row, bool periodic,
                         std::span<const double> window) {
        row_departures(row, periodic, departures_);
        for (std::size_t x = 0; x < window.size(); ++x) departures_[x] *= window[x];
    }

    FourierTransform transform_;
    std::vector<double> departures_;
    std::vector<Complex> pair_;
    std::vector<Complex> spectrum_;
};

/// For real rows a and b, z = a + ib: |A(k)|² + |B(k)|² = (|Z(k)|² + |Z(n − k)|²) / 2.
std::vector<double> power_of_rows(const Grid& bed, bool periodic, std::size_t length,
                                  std::span<const double> window) {
    std::vector<double> power(length / 2 + 1);
    RowPairs pairs(static_cast<std::size_t>(bed.nx()), length);
    for (int y = 0; y < bed.ny(); y += 2) {
        pairs.clear();
        pairs.set_real(bed.row(y), periodic, window);
        if (y + 1 < bed.ny()) pairs.set_imaginary(bed.row(y + 1), periodic, window);
        const std::vector<Complex>& z = pairs.transformed();
        power[0] += std::norm(z[0]);
        for (std::size_t k = 1; k < power.size(); ++k) {
            power[k] += 0.5 * (std::norm(z[k]) + std::norm(z[length - k]));
        }
    }
    return power;
}

/// Σ_k S(k) exp(2πi·ks/n) / n at s = 0 … n − 1 of a spectrum whose sum is real: S(n − k) = S(k)*.
std::vector<double> back_to_shifts(std::vector<Complex> spectrum) {
    const std::size_t length = spectrum.size();
    for (Complex& value : spectrum) value = std::conj(value);
    std::vector<Complex> sums(length);
    FourierTransform(length).forward(spectrum, sums);
    std::vector<double> result(length);
    for (std::size_t s = 0; s < length; ++s) {
        result[s] = sums[s].real() / static_cast<double>(length);
    }
    return result;
}

}  // namespace

std::vector<double> power_along_x(const Grid& bed, bool periodic) {
    if (bed.empty()) return {};
    const auto nx = static_cast<std::size_t>(bed.nx());
    const std::vector<double> window = periodic ? std::vector<double>() : hann_window(nx);
    return power_of_rows(bed, periodic, nx, window);
}

std::vector<double> autocorrelation_along_x(const Grid& bed, bool periodic) {
    if (bed.empty()) return {};
    const auto nx = static_cast<std::size_t>(bed.nx());
    const std::size_t length = periodic ? nx : std::bit_ceil(nx + nx / 2 + 1);
    const std::vector<double> power = power_of_rows(bed, periodic, length, {});
    std::vector<Complex> spectrum(length);
    for (std::size_t k = 0; k < length; ++k) spectrum[k] = power[std::min(k, length - k)];
    std::vector<double> result = back_to_shifts(std::move(spectrum));
    if (!(result[0] > 0.0)) return {};
    if (!periodic) result.resize(nx / 2 + 1);
    const double whole = result[0];
    for (std::size_t s = 0; s < result.size(); ++s) {
        const auto overlap = static_cast<double>(periodic ? nx : nx - s);
        result[s] *= static_cast<double>(nx) / (overlap * whole);
    }
    return result;
}

std::vector<double> cross_correlation_along_x(const Grid& earlier, const Grid& later) {
    if (earlier.nx() != later.nx() || earlier.ny() != later.ny()) {
        throw Error("two beds are compared whose sizes differ");
    }
    if (earlier.empty()) return {};
    const auto nx = static_cast<std::size_t>(earlier.nx());
    RowPairs pairs(nx, nx);
    std::vector<Complex> products(nx);
    double earlier_squares = 0.0;
    double later_squares = 0.0;
    for (int y = 0; y < earlier.ny(); ++y) {
        pairs.set_real(earlier.row(y), true);
        earlier_squares += pairs.squares();
        pairs.set_imaginary(later.row(y), true);
        later_squares += pairs.squares();
        const std::vector<Complex>& z = pairs.transformed();
        for (std::size_t k = 0; k < nx; ++k) {
            const Complex mirrored = std::conj(z[k == 0 ? 0 : nx - k]);
            const Complex a = 0.5 * (z[k] + mirrored);
            const Complex twice_ib = z[k] - mirrored;
            const Complex b{0.5 * twice_ib.imag(), -0.5 * twice_ib.real()};
            products[k] += Complex{a.real() * b.real() + a.imag() * b.imag(),
                                   a.real() * b.imag() - a.imag() * b.real()};
        }
    }
    const double whole = std::sqrt(earlier_squares * later_squares);
    if (!(whole > 0.0)) return {};
    std::vector<double> result = back_to_shifts(std::move(products));
    for (double& value : result) value /= whole;
    return result;
}

}  // namespace fumon
