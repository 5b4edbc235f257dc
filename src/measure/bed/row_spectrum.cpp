#include "measure/bed/row_spectrum.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/error.h"
#include "measure/bed/detrended_row.h"
#include "numerics/fourier_transform.h"

namespace fumon {

namespace {

constexpr double turn = 6.283185307179586;

std::vector<double> hann_window(std::size_t length) {
    std::vector<double> window(length);
    for (std::size_t x = 0; x < length; ++x) {
        window[x] = 0.5 - 0.5 * elementary::cos(turn * (static_cast<double>(x) + 0.5) /
                                                static_cast<double>(length));
    }
    return window;
}

/// The transforms of rows' departures, a batch at a time, along `length` sites (those past nx are
/// zero).
class RowSpectra {
  public:
    static constexpr std::size_t rows = FourierTransform::rows;
    static_assert(rows <= most_row_means);

    RowSpectra(std::size_t nx, std::size_t length)
        : transform_(length),
          scratch_(transform_.scratch()),
          departures_(nx),
          values_(length * rows),
          real_((length / 2 + 1) * rows),
          imaginary_(real_.size()) {}

    void clear() { std::fill(values_.begin(), values_.end(), 0.0); }
    /// Makes `count` rows of a bed, from `first` on, those of the batch from `place` on.
    void set(std::size_t place, const Grid& bed, int first, int count, bool periodic,
             std::span<const double> window = {}) {
        const auto means = row_means(bed, first, count);
        for (int row = 0; row < count; ++row, ++place) {
            detrend_row(bed.row(first + row), means[static_cast<std::size_t>(row)], periodic,
                        departures_);
            for (std::size_t x = 0; x < window.size(); ++x) departures_[x] *= window[x];
            for (std::size_t x = 0; x < departures_.size(); ++x)
                values_[x * rows + place] = departures_[x];
        }
    }
    /// Σ f² of each row's departures.
    [[nodiscard]] std::array<double, rows> squares() const {
        std::array<double, rows> sums{};
        for (std::size_t x = 0; x < departures_.size(); ++x) {
            const double* at = values_.data() + x * rows;
            for (std::size_t row = 0; row < rows; ++row) sums[row] += at[row] * at[row];
        }
        return sums;
    }
    void transform() {
        transform_.forward(values_.data(), rows, real_.data(), imaginary_.data(), rows, scratch_);
    }
    /// Of mode k, the batch's rows side by side.
    [[nodiscard]] const double* real(std::size_t k) const { return &real_[k * rows]; }
    [[nodiscard]] const double* imaginary(std::size_t k) const { return &imaginary_[k * rows]; }

  private:
    FourierTransform transform_;
    FourierTransform::Scratch scratch_;
    std::vector<double> departures_;
    std::vector<double> values_;
    std::vector<double> real_;
    std::vector<double> imaginary_;
};

std::vector<double> power_of_rows(const Grid& bed, bool periodic, std::size_t length,
                                  std::span<const double> window) {
    std::vector<double> power(length / 2 + 1);
    RowSpectra spectra(static_cast<std::size_t>(bed.nx()), length);
    for (int first = 0; first < bed.ny(); first += static_cast<int>(RowSpectra::rows)) {
        spectra.clear();
        spectra.set(0, bed, first, std::min(static_cast<int>(RowSpectra::rows), bed.ny() - first),
                    periodic, window);
        spectra.transform();
        for (std::size_t k = 0; k < power.size(); ++k) {
            const double* re = spectra.real(k);
            const double* im = spectra.imaginary(k);
            for (std::size_t row = 0; row < RowSpectra::rows; ++row)
                power[k] += re[row] * re[row] + im[row] * im[row];
        }
    }
    return power;
}

/// Σ_k S(k) exp(2πi·ks/n) / n at s = 0 … n − 1 of the half k = 0 … n/2 of a spectrum whose sum is
/// real: S(n − k) = S(k)*.
std::vector<double> back_to_shifts(std::span<const double> real, std::span<const double> imaginary,
                                   std::size_t length) {
    constexpr std::size_t rows = FourierTransform::rows;  // of which the first is used
    std::vector<double> spread_real(real.size() * rows);
    std::vector<double> spread_imaginary(real.size() * rows);
    for (std::size_t k = 0; k < real.size(); ++k) {
        spread_real[k * rows] = real[k];
        spread_imaginary[k * rows] = imaginary[k];
    }
    const FourierTransform transform(length);
    FourierTransform::Scratch scratch = transform.scratch();
    std::vector<double> sums(length * rows);
    transform.backward(spread_real.data(), spread_imaginary.data(), rows, sums.data(), rows,
                       scratch);
    std::vector<double> result(length);
    for (std::size_t s = 0; s < length; ++s)
        result[s] = sums[s * rows] / static_cast<double>(length);
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
    std::vector<double> result = back_to_shifts(power, std::vector<double>(power.size()), length);
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
        throw Error("the two compared beds differ in size");
    }
    if (earlier.empty()) return {};
    const auto nx = static_cast<std::size_t>(earlier.nx());
    RowSpectra spectra(nx, nx);
    constexpr std::size_t pairs = RowSpectra::rows / 2;  // the later rows come after the earlier
    std::vector<double> products_real(nx / 2 + 1);
    std::vector<double> products_imaginary(nx / 2 + 1);
    double earlier_squares = 0.0;
    double later_squares = 0.0;
    for (int first = 0; first < earlier.ny(); first += static_cast<int>(pairs)) {
        spectra.clear();
        const int count = std::min(static_cast<int>(pairs), earlier.ny() - first);
        spectra.set(0, earlier, first, count, true);
        spectra.set(pairs, later, first, count, true);
        const auto squares = spectra.squares();
        for (std::size_t row = 0; row < static_cast<std::size_t>(count); ++row) {
            earlier_squares += squares[row];
            later_squares += squares[pairs + row];
        }
        spectra.transform();
        for (std::size_t k = 0; k < products_real.size(); ++k) {
            const double* re = spectra.real(k);
            const double* im = spectra.imaginary(k);
            for (std::size_t row = 0; row < pairs; ++row) {
                products_real[k] += re[row] * re[pairs + row] + im[row] * im[pairs + row];
                products_imaginary[k] += re[row] * im[pairs + row] - im[row] * re[pairs + row];
            }
        }
    }
    const double whole = std::sqrt(earlier_squares * later_squares);
    if (!(whole > 0.0)) return {};
    std::vector<double> result = back_to_shifts(products_real, products_imaginary, nx);
    for (double& value : result) value /= whole;
    return result;
}

}  // namespace fumon
