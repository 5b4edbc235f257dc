// Fourier transforms of 8 real rows at a time.
//
// 1. Rows lie side by side, point after point. Two real rows are the real and the imaginary part of
//    one complex row, so that 8 real rows are 4 complex ones, and each operation of a butterfly is
//    one vector operation without shuffles:
//
//        point i   | row 0  row 1  row 2  row 3 | row 4  row 5  row 6  row 7 |   64 bytes
//                  |      real parts of 4       |      imaginary parts       |
//
// 2. Stockham's method: each stage reads one half of the scratch and writes the other, in the order
//    that the next stage reads, so that no digit reversal is needed.
//
//        values -> [from] -> [to] -> [from] -> ... -> spectra
//
// 3. The first stage reads the caller's array with its stride, and the last stage of the inverse
//    writes to it: two copies less.
// 4. Radices 4, 5, 2 and 3, then other primes up to 127 by the definition. Where a larger prime
//    divides the length, the transform is a convolution with a chirp over a power of two.
// 5. split_spectra() takes the spectra of the two rows of a pair apart; merge_spectra() joins them.
//    The inverse is the forward transform of i times the conjugate, whose parts change places.
// 6. Sines and cosines are fumon's own, sums have one order, and vectors have 4 lanes at most: the
//    bits are the same on every processor.
//
// Cochran et al. (1967); Bluestein (1970).

#include "numerics/fourier_transform.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>
#include <utility>

#include "base/elementary.h"
#include "numerics/fourier_vectors.h"

namespace fumon {

namespace {

/// Up to here a butterfly by the definition is affordable, and more accurate than a convolution.
constexpr std::size_t largest_radix = 127;

constexpr std::size_t half = fourier::half;
constexpr std::size_t rows = FourierTransform::rows;  // of a point: 4 real parts, 4 imaginary ones
static_assert(rows == fourier::rows);

}  // namespace

/// mi = (m² + i² − (m − i)²)/2 makes the transform a convolution with a chirp exp(iπ i²/n).
class FourierTransform::Convolution {
  public:
    explicit Convolution(std::size_t length)
        : padded_(std::bit_ceil(2 * length - 1)),
          kernel_real_(padded_.length_),
          kernel_imaginary_(padded_.length_) {
        for (std::uint64_t i = 0; i < length; ++i) {
            const auto square = static_cast<double>(i * i % (2 * length));
            const double angle = std::numbers::pi * square / static_cast<double>(length);
            cosine_.push_back(elementary::cos(angle));
            sine_.push_back(elementary::sin(angle));
        }
        Scratch scratch = padded_.scratch();
        std::fill_n(scratch.from, padded_.length_ * rows, 0.0);
        for (std::size_t i = 0; i < length; ++i) {
            for (const std::size_t at : {i, (padded_.length_ - i) % padded_.length_}) {
                scratch.from[at * rows] = cosine_[i];
                scratch.from[at * rows + half] = sine_[i];
            }
        }
        padded_.transform(scratch);
        // The inverse transform's factor is the kernel's.
        const double scale = 1.0 / static_cast<double>(padded_.length_);
        for (std::size_t m = 0; m < padded_.length_; ++m) {
            kernel_real_[m] = scale * scratch.from[m * rows];
            kernel_imaginary_[m] = scale * scratch.from[m * rows + half];
        }
    }

    [[nodiscard]] Scratch scratch() const { return padded_.scratch(); }

    void transform(Scratch& scratch) const {
        const std::size_t length = cosine_.size();
        fourier::rotate_points(scratch.from, cosine_.data(), sine_.data(), length);
        std::fill_n(&scratch.from[length * rows], (padded_.length_ - length) * rows, 0.0);
        padded_.transform(scratch);
        // The inverse transform is the forward one between two conjugations.
        fourier::multiply_conjugate(scratch.from, kernel_real_.data(), kernel_imaginary_.data(),
                                    padded_.length_);
        padded_.transform(scratch);
        double* z = scratch.from;
        for (std::size_t m = 0; m < length; ++m) {
            for (std::size_t l = half; l < rows; ++l) z[m * rows + l] = -z[m * rows + l];
        }
        fourier::rotate_points(z, cosine_.data(), sine_.data(), length);
    }

  private:
    FourierTransform padded_;
    std::vector<double> cosine_;  ///< of the chirp
    std::vector<double> sine_;
    std::vector<double> kernel_real_;
    std::vector<double> kernel_imaginary_;
};

FourierTransform::FourierTransform(std::size_t length) : length_(length) {
    std::size_t rest = length_;
    for (const std::size_t radix : {4UL, 5UL, 2UL, 3UL}) {
        for (; rest % radix == 0; rest /= radix) radices_.push_back(radix);
    }
    for (std::size_t radix = 7; rest > 1 && radix <= largest_radix; radix += 2) {
        for (; rest % radix == 0; rest /= radix) radices_.push_back(radix);
    }
    if (rest > 1) {
        convolution_ = std::make_unique<const Convolution>(length_);
        return;
    }
    for (std::size_t j = 0; j < length_; ++j) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(length_);
        cosine_.push_back(elementary::cos(angle));
        sine_.push_back(elementary::sin(angle));
    }
}

FourierTransform::~FourierTransform() = default;

FourierTransform::Scratch FourierTransform::scratch() const {
    if (convolution_) return convolution_->scratch();
    return Scratch(length_ * rows);
}

/// Of the 4 complex rows in scratch.from, in place.
void FourierTransform::transform(Scratch& scratch) const {
    if (convolution_) {
        convolution_->transform(scratch);
    } else if (!radices_.empty()) {
        run_stages({scratch.from, rows}, {behind_stages(scratch), rows}, false, scratch);
        if (behind_stages(scratch) != scratch.from) std::swap(scratch.from, scratch.to);
    }
}

/// The half of the scratch that the last stage does not read: the first stage reads scratch.from.
double* FourierTransform::behind_stages(Scratch& scratch) const {
    return radices_.size() % 2 == 0 ? scratch.from : scratch.to;
}

void FourierTransform::run_stages(const Points<const double>& from, const Points<double>& to,
                                  bool mirrored, Scratch& scratch) const {
    const double* here = from.first;
    std::size_t here_step = from.step;
    std::size_t remaining = length_;
    std::size_t stride = 1;
    for (std::size_t n = 0; n < radices_.size(); ++n) {
        const std::size_t radix = radices_[n];
        remaining /= radix;
        const bool last = n + 1 == radices_.size();
        double* there = to.first;
        if (!last) there = n % 2 == 0 ? scratch.to : scratch.from;
        const fourier::Stage stage{radix,           remaining,    stride,    length_,
                                   cosine_.data(),  sine_.data(), here_step, last ? to.step : rows,
                                   mirrored && last};
        if (radix == 4) {
            fourier::butterflies_of_four(stage, here, there);
        } else if (radix == 5) {
            fourier::butterflies_of_five(stage, here, there);
        } else {
            fourier::butterflies(stage, here, there);
        }
        here = there;
        here_step = rows;
        stride *= radix;
    }
}

void FourierTransform::forward(const double* values, std::size_t stride, double* real,
                               double* imaginary, std::size_t spectrum_stride,
                               Scratch& scratch) const {
    const fourier::Spectra spectra{real, imaginary, spectrum_stride};
    if (in_stages()) {
        double* transformed = behind_stages(scratch);
        run_stages({values, stride}, {transformed, rows}, false, scratch);
        fourier::split_spectra(transformed, length_, spectra);
        return;
    }
    for (std::size_t i = 0; i < length_; ++i)
        std::copy_n(values + i * stride, rows, &scratch.from[i * rows]);
    transform(scratch);
    fourier::split_spectra(scratch.from, length_, spectra);
}

void FourierTransform::backward(const double* real, const double* imaginary,
                                std::size_t spectrum_stride, double* values, std::size_t stride,
                                Scratch& scratch) const {
    // The inverse of z is the forward transform of i·conj z, likewise turned back: its parts
    // change places.
    fourier::merge_spectra({real, imaginary, spectrum_stride}, length_, scratch.from);
    if (in_stages()) {
        run_stages({scratch.from, rows}, {values, stride}, true, scratch);
        return;
    }
    transform(scratch);
    for (std::size_t i = 0; i < length_; ++i) {
        const double* point = &scratch.from[i * rows];
        std::copy_n(point + half, half, values + i * stride);
        std::copy_n(point, half, values + i * stride + half);
    }
}

}  // namespace fumon
