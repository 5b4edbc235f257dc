#include "measure/fourier_transform.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "terrain/elementary.h"

namespace fumon {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t largest_factor = 31;
constexpr double half_turn = 3.141592653589793;

bool has_small_factors(std::size_t length) {
    for (std::size_t factor = 2; factor <= largest_factor; ++factor) {
        while (length % factor == 0 && length > 1) length /= factor;
    }
    return length <= 1;
}

}  // namespace

class FourierTransform::Method {
  public:
    Method() = default;
    virtual ~Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;
    virtual void forward(std::span<const Complex> values, std::span<Complex> spectrum) = 0;
};

class FourierTransform::MixedRadix : public Method {
  public:
    void forward(std::span<const Complex> values, std::span<Complex> spectrum) override {
        if (values.size() < 2) {  // which Eigen does not take
            std::copy(values.begin(), values.end(), spectrum.begin());
            return;
        }
        if (values.size() == 1) {  // has no factors, which Eigen's transform does not foresee
            spectrum[0] = values[0];
            return;
        }
        transform_.fwd(spectrum.data(), values.data(), static_cast<Eigen::Index>(values.size()));
    }

  private:
    Eigen::FFT<double> transform_;
};

/// kx = (k² + x² − (k − x)²)/2 makes the transform a convolution with a chirp exp(iπ x²/n).
class FourierTransform::Convolution : public Method {
  public:
    explicit Convolution(std::size_t length)
        : chirp_(length),
          padded_(std::bit_ceil(2 * length - 1)),
          values_(padded_),
          spectrum_(padded_),
          kernel_(padded_) {
        for (std::uint64_t x = 0; x < length; ++x) {
            const auto square = static_cast<double>(x * x % (2 * length));
            const double angle = half_turn * square / static_cast<double>(length);
            chirp_[x] = {elementary::cos(angle), -elementary::sin(angle)};
            values_[x] = std::conj(chirp_[x]);
            if (x > 0) values_[padded_ - x] = values_[x];
        }
        transform_.forward(values_, kernel_);
    }

    void forward(std::span<const Complex> values, std::span<Complex> spectrum) override {
        const std::size_t length = chirp_.size();
        std::fill(values_.begin(), values_.end(), Complex());
        for (std::size_t x = 0; x < length; ++x) values_[x] = values[x] * chirp_[x];
        transform_.forward(values_, spectrum_);
        // The inverse transform is the forward one between two conjugations.
        for (std::size_t k = 0; k < padded_; ++k) {
            spectrum_[k] = std::conj(spectrum_[k] * kernel_[k]);
        }
        transform_.forward(spectrum_, values_);
        const double scale = 1.0 / static_cast<double>(padded_);
        for (std::size_t k = 0; k < length; ++k) {
            spectrum[k] = std::conj(values_[k]) * scale * chirp_[k];
        }
    }

  private:
    MixedRadix transform_;
    std::vector<Complex> chirp_;
    std::size_t padded_;
    std::vector<Complex> values_;
    std::vector<Complex> spectrum_;
    std::vector<Complex> kernel_;
};

FourierTransform::FourierTransform(std::size_t length) {
    if (has_small_factors(length)) {
        method_ = std::make_unique<MixedRadix>();
    } else {
        method_ = std::make_unique<Convolution>(length);
    }
}

FourierTransform::~FourierTransform() = default;

void FourierTransform::forward(std::span<const Complex> values, std::span<Complex> spectrum) {
    method_->forward(values, spectrum);
}

}  // namespace fumon
