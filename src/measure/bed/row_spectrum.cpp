#include "measure/bed/row_spectrum.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "measure/bed/row_batch.h"
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

/// Adds the power of each mode of a batch's spectra, row by row.
void add_power(const double* real, const double* imaginary, std::vector<double>& power) {
    constexpr std::size_t rows = RowBatch::rows;
    for (std::size_t k = 0; k < power.size(); ++k) {
        const double* re = real + k * rows;
        const double* im = imaginary + k * rows;
        for (std::size_t row = 0; row < rows; ++row)
            power[k] += re[row] * re[row] + im[row] * im[row];
    }
}

/// The transforms of rows' departures, a batch at a time, along `length` sites (those past nx are
/// zero).
class RowTransformer {
  public:
    static constexpr std::size_t rows = FourierTransform::rows;
    static_assert(rows == RowBatch::rows);

    RowTransformer(std::size_t nx, std::size_t length)
        : transform_(length),
          scratch_(transform_.scratch()),
          padded_(length > nx ? length * rows : 0),
          real_((length / 2 + 1) * rows),
          imaginary_(real_.size()) {}

    /// Of a batch of detrended rows, times a window where there is one.
    void transform(const RowBatch& batch, std::span<const double> window = {}) {
        transform(batch, window, real_.data(), imaginary_.data());
    }
    /// Of a batch of detrended rows, to a place for real_.size() values each.
    void transform(const RowBatch& batch, std::span<const double> window, double* real,
                   double* imaginary) {
        const double* values = batch.values();
        if (!window.empty() || !padded_.empty()) {
            padded_.resize(std::max(padded_.size(), batch.nx() * rows));
            for (std::size_t x = 0; x < batch.nx(); ++x) {
                const double factor = window.empty() ? 1.0 : window[x];
                for (std::size_t row = 0; row < rows; ++row)
                    padded_[x * rows + row] = values[x * rows + row] * factor;
            }
            values = padded_.data();
        }
        transform_.forward(values, rows, real, imaginary, rows, scratch_);
    }
    /// Adds the power of each mode, row by row.
    void add_power(std::vector<double>& power) const {
        fumon::add_power(real_.data(), imaginary_.data(), power);
    }

  private:
    FourierTransform transform_;
    FourierTransform::Scratch scratch_;
    std::vector<double> padded_;
    std::vector<double> real_;
    std::vector<double> imaginary_;
};

int rows_from(const Grid& bed, int first) {
    return std::min(static_cast<int>(RowBatch::rows), bed.ny() - first);
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

RowPower power_of_rows(const Grid& bed, bool periodic) {
    if (bed.empty()) return {};
    const auto nx = static_cast<std::size_t>(bed.nx());
    const std::size_t padded = periodic ? nx : std::bit_ceil(nx + nx / 2 + 1);
    const std::vector<double> window = periodic ? std::vector<double>() : hann_window(nx);
    RowPower power;
    power.windowed.resize(nx / 2 + 1);
    RowBatch batch(nx);
    RowTransformer spectra(nx, nx);
    std::optional<RowTransformer> of_padded;
    if (!periodic) {
        of_padded.emplace(nx, padded);
        power.padded.resize(padded / 2 + 1);
    }
    for (int first = 0; first < bed.ny(); first += static_cast<int>(RowBatch::rows)) {
        batch.take(bed, first, rows_from(bed, first));
        batch.detrend(periodic);
        spectra.transform(batch, window);
        spectra.add_power(power.windowed);
        if (!of_padded) continue;
        of_padded->transform(batch);
        of_padded->add_power(power.padded);
    }
    return power;
}

std::vector<double> power_along_x(const Grid& bed, bool periodic) {
    return power_of_rows(bed, periodic).windowed;
}

std::vector<double> autocorrelation(const RowPower& of_rows, std::size_t nx, bool periodic) {
    const std::vector<double>& power = periodic ? of_rows.windowed : of_rows.padded;
    if (power.empty()) return {};
    const std::size_t length = periodic ? nx : std::bit_ceil(nx + nx / 2 + 1);
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

std::vector<double> autocorrelation_along_x(const Grid& bed, bool periodic) {
    return autocorrelation(power_of_rows(bed, periodic), static_cast<std::size_t>(bed.nx()),
                           periodic);
}

RowPower find_row_spectra(const Grid& bed, RowSpectra& spectra) {
    spectra.nx = bed.nx();
    spectra.ny = bed.ny();
    spectra.squares = 0.0;
    if (bed.empty()) return {};
    constexpr std::size_t rows = RowBatch::rows;
    const auto nx = static_cast<std::size_t>(bed.nx());
    const std::size_t of_batch = (nx / 2 + 1) * rows;
    const std::size_t batches = (static_cast<std::size_t>(bed.ny()) + rows - 1) / rows;
    spectra.real.resize(of_batch * batches);
    spectra.imaginary.resize(of_batch * batches);
    RowPower power;
    power.windowed.resize(nx / 2 + 1);
    RowBatch batch(nx);
    RowTransformer transformer(nx, nx);
    for (std::size_t j = 0; j < batches; ++j) {
        const auto first = static_cast<int>(j * rows);
        batch.take(bed, first, rows_from(bed, first));
        batch.detrend(true);
        for (const double squares : batch.squares()) spectra.squares += squares;
        double* real = spectra.real.data() + j * of_batch;
        double* imaginary = spectra.imaginary.data() + j * of_batch;
        transformer.transform(batch, {}, real, imaginary);
        add_power(real, imaginary, power.windowed);
    }
    return power;
}

std::vector<double> cross_correlation_along_x(const Grid& earlier, const Grid& later) {
    RowSpectra before;
    RowSpectra after;
    find_row_spectra(earlier, before);
    find_row_spectra(later, after);
    return cross_correlation(before, after);
}

std::vector<double> cross_correlation(const RowSpectra& earlier, const RowSpectra& later) {
    if (earlier.nx != later.nx || earlier.ny != later.ny)
        throw Error("the two compared beds differ in size");
    const double whole = std::sqrt(earlier.squares * later.squares);
    if (!(whole > 0.0)) return {};
    constexpr std::size_t rows = RowBatch::rows;
    const auto nx = static_cast<std::size_t>(earlier.nx);
    const std::size_t of_batch = (nx / 2 + 1) * rows;
    // Eight sums side by side for each mode, each of every eighth row.
    std::vector<double> real(of_batch);
    std::vector<double> imaginary(of_batch);
    for (std::size_t first = 0; first < earlier.real.size(); first += of_batch) {
        const double* before_real = earlier.real.data() + first;
        const double* before_imaginary = earlier.imaginary.data() + first;
        const double* after_real = later.real.data() + first;
        const double* after_imaginary = later.imaginary.data() + first;
        for (std::size_t i = 0; i < of_batch; ++i) {
            real[i] += before_real[i] * after_real[i] + before_imaginary[i] * after_imaginary[i];
            imaginary[i] +=
                before_real[i] * after_imaginary[i] - before_imaginary[i] * after_real[i];
        }
    }
    std::vector<double> products_real(nx / 2 + 1);
    std::vector<double> products_imaginary(nx / 2 + 1);
    for (std::size_t i = 0; i < of_batch; ++i) {
        products_real[i / rows] += real[i];
        products_imaginary[i / rows] += imaginary[i];
    }
    std::vector<double> result = back_to_shifts(products_real, products_imaginary, nx);
    for (double& value : result) value /= whole;
    return result;
}

}  // namespace fumon
