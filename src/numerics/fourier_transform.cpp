#include "numerics/fourier_transform.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/elementary.h"
#include "base/multiversion.h"

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

/// Complex values, real and imaginary parts apart.
struct Parts {
    std::vector<double> real;
    std::vector<double> imaginary;
    Parts() = default;
    explicit Parts(std::size_t count) : real(count), imaginary(count) {}
};

struct FourierStage {
    std::size_t radix;
    std::size_t part;
    std::size_t stride;
    std::size_t length;
};

FUMON_MULTIVERSION
void butterflies_of_two(const FourierStage& stage, const Parts& turns, const Parts& from,
                        Parts& to) {
    const std::size_t reach = stage.part * stage.stride;
    for (std::size_t p = 0; p < stage.part; ++p) {
        const double c = turns.real[p * stage.stride];
        const double s = turns.imaginary[p * stage.stride];
        const double* re = &from.real[p * stage.stride];
        const double* im = &from.imaginary[p * stage.stride];
        double* to_re = &to.real[2 * p * stage.stride];
        double* to_im = &to.imaginary[2 * p * stage.stride];
        FUMON_INDEPENDENT
        for (std::size_t q = 0; q < stage.stride; ++q) {
            to_re[q] = re[q] + re[q + reach];
            to_im[q] = im[q] + im[q + reach];
            const double a = re[q] - re[q + reach];
            const double b = im[q] - im[q + reach];
            to_re[q + stage.stride] = a * c - b * s;
            to_im[q + stage.stride] = a * s + b * c;
        }
    }
}

FUMON_MULTIVERSION
void butterflies_of_four(const FourierStage& stage, const Parts& turns, const Parts& from,
                         Parts& to) {
    const std::size_t reach = stage.part * stage.stride;
    const std::size_t stride = stage.stride;
    for (std::size_t p = 0; p < stage.part; ++p) {
        const double c1 = turns.real[p * stride];
        const double s1 = turns.imaginary[p * stride];
        const double c2 = turns.real[2 * p * stride];
        const double s2 = turns.imaginary[2 * p * stride];
        const double c3 = turns.real[3 * p * stride];
        const double s3 = turns.imaginary[3 * p * stride];
        const double* re = &from.real[p * stride];
        const double* im = &from.imaginary[p * stride];
        double* to_re = &to.real[4 * p * stride];
        double* to_im = &to.imaginary[4 * p * stride];
        FUMON_INDEPENDENT
        for (std::size_t q = 0; q < stride; ++q) {
            const double even_re = re[q] + re[q + 2 * reach];
            const double even_im = im[q] + im[q + 2 * reach];
            const double odd_re = re[q + reach] + re[q + 3 * reach];
            const double odd_im = im[q + reach] + im[q + 3 * reach];
            const double apart_re = re[q] - re[q + 2 * reach];
            const double apart_im = im[q] - im[q + 2 * reach];
            const double turned_re = im[q + reach] - im[q + 3 * reach];  // −i times the difference
            const double turned_im = re[q + 3 * reach] - re[q + reach];
            to_re[q] = even_re + odd_re;
            to_im[q] = even_im + odd_im;
            const double a1 = apart_re + turned_re;
            const double b1 = apart_im + turned_im;
            to_re[q + stride] = a1 * c1 - b1 * s1;
            to_im[q + stride] = a1 * s1 + b1 * c1;
            const double a2 = even_re - odd_re;
            const double b2 = even_im - odd_im;
            to_re[q + 2 * stride] = a2 * c2 - b2 * s2;
            to_im[q + 2 * stride] = a2 * s2 + b2 * c2;
            const double a3 = apart_re - turned_re;
            const double b3 = apart_im - turned_im;
            to_re[q + 3 * stride] = a3 * c3 - b3 * s3;
            to_im[q + 3 * stride] = a3 * s3 + b3 * c3;
        }
    }
}

constexpr std::size_t most_pairs = largest_factor / 2;

/// Of an odd radix: points j and radix − j are turned to either side, so that their sum and
/// difference serve two results.
[[gnu::always_inline]] inline void odd_butterflies(const FourierStage& stage, std::size_t radix,
                                                   const Parts& turns, const Parts& from,
                                                   Parts& to) {
    const std::size_t stride = stage.stride;
    const std::size_t reach = stage.part * stride;
    const std::size_t pairs = radix / 2;
    for (std::size_t p = 0; p < stage.part; ++p) {
        const double* re = &from.real[p * stride];
        const double* im = &from.imaginary[p * stride];
        double* to_re = &to.real[radix * p * stride];
        double* to_im = &to.imaginary[radix * p * stride];
        for (std::size_t k = 0; k <= pairs; ++k) {
            const std::size_t mirrored = k == 0 ? 0 : radix - k;
            const double c1 = turns.real[p * k * stride];
            const double s1 = turns.imaginary[p * k * stride];
            const double c2 = turns.real[p * mirrored * stride];
            const double s2 = turns.imaginary[p * mirrored * stride];
            std::array<double, most_pairs> c{};
            std::array<double, most_pairs> s{};
            for (std::size_t j = 0; j < pairs; ++j) {
                const std::size_t turn = (j + 1) * k % radix * (stage.length / radix);
                c[j] = turns.real[turn];
                s[j] = turns.imaginary[turn];
            }
            FUMON_INDEPENDENT
            for (std::size_t q = 0; q < stride; ++q) {
                double even_re = re[q];
                double even_im = im[q];
                double odd_re = 0.0;
                double odd_im = 0.0;
                for (std::size_t j = 0; j < pairs; ++j) {
                    const std::size_t near = q + (j + 1) * reach;
                    const std::size_t far = q + (radix - j - 1) * reach;
                    even_re += (re[near] + re[far]) * c[j];
                    even_im += (im[near] + im[far]) * c[j];
                    odd_re -= (im[near] - im[far]) * s[j];
                    odd_im += (re[near] - re[far]) * s[j];
                }
                const double a1 = even_re + odd_re;
                const double b1 = even_im + odd_im;
                const double a2 = even_re - odd_re;
                const double b2 = even_im - odd_im;
                // For k = 0 both are the same result, and nothing is odd.
                to_re[q + mirrored * stride] = a2 * c2 - b2 * s2;
                to_im[q + mirrored * stride] = a2 * s2 + b2 * c2;
                to_re[q + k * stride] = a1 * c1 - b1 * s1;
                to_im[q + k * stride] = a1 * s1 + b1 * c1;
            }
        }
    }
}

FUMON_MULTIVERSION
void butterflies_of_three(const FourierStage& stage, const Parts& turns, const Parts& from,
                          Parts& to) {
    odd_butterflies(stage, 3, turns, from, to);
}

FUMON_MULTIVERSION
void butterflies_of_five(const FourierStage& stage, const Parts& turns, const Parts& from,
                         Parts& to) {
    odd_butterflies(stage, 5, turns, from, to);
}

FUMON_MULTIVERSION
void butterflies(const FourierStage& stage, const Parts& turns, const Parts& from, Parts& to) {
    odd_butterflies(stage, stage.radix, turns, from, to);
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

/// Stockham's method (Cochran et al. 1967): a stage of radix r makes, of sequences of length r·part
/// at the distance `stride`, r times as many of length part; after the last one the values stand in
/// order. Real and imaginary parts lie apart, so that the loop over the sequences vectorises.
class FourierTransform::MixedRadix : public Method {
  public:
    explicit MixedRadix(std::size_t length) : length_(length), from_(length), to_(length) {
        std::size_t rest = length;
        for (const std::size_t radix : {4U, 2U}) {
            for (; rest % radix == 0; rest /= radix) radices_.push_back(radix);
        }
        for (std::size_t radix = 3; rest > 1; radix += 2) {
            for (; rest % radix == 0; rest /= radix) radices_.push_back(radix);
        }
        for (std::size_t j = 0; j < length; ++j) {
            const std::size_t nearer = std::min(j, length - j);
            const double angle =
                2.0 * half_turn * static_cast<double>(nearer) / static_cast<double>(length);
            turns_.real.push_back(elementary::cos(angle));
            turns_.imaginary.push_back(j == nearer ? -elementary::sin(angle)
                                                   : elementary::sin(angle));
        }
    }

    void forward(std::span<const Complex> values, std::span<Complex> spectrum) override {
        for (std::size_t i = 0; i < length_; ++i) {
            from_.real[i] = values[i].real();
            from_.imaginary[i] = values[i].imag();
        }
        std::size_t part = length_;
        std::size_t stride = 1;
        for (const std::size_t radix : radices_) {
            part /= radix;
            const FourierStage stage{radix, part, stride, length_};
            const auto pass = radix == 2   ? butterflies_of_two
                              : radix == 3 ? butterflies_of_three
                              : radix == 4 ? butterflies_of_four
                              : radix == 5 ? butterflies_of_five
                                           : butterflies;
            pass(stage, turns_, from_, to_);
            std::swap(from_, to_);
            stride *= radix;
        }
        for (std::size_t i = 0; i < length_; ++i) spectrum[i] = {from_.real[i], from_.imaginary[i]};
    }

  private:
    std::size_t length_;
    std::vector<std::size_t> radices_;
    Parts turns_;  ///< exp(−2πi·j/length)
    Parts from_;
    Parts to_;
};

/// kx = (k² + x² − (k − x)²)/2 makes the transform a convolution with a chirp exp(iπ x²/n).
class FourierTransform::Convolution : public Method {
  public:
    explicit Convolution(std::size_t length)
        : chirp_(length),
          padded_(std::bit_ceil(2 * length - 1)),
          transform_(padded_),
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
    std::vector<Complex> chirp_;
    std::size_t padded_;
    MixedRadix transform_;
    std::vector<Complex> values_;
    std::vector<Complex> spectrum_;
    std::vector<Complex> kernel_;
};

FourierTransform::FourierTransform(std::size_t length) {
    if (has_small_factors(length)) {
        method_ = std::make_unique<MixedRadix>(length);
    } else {
        method_ = std::make_unique<Convolution>(length);
    }
}

FourierTransform::~FourierTransform() = default;

void FourierTransform::forward(std::span<const Complex> values, std::span<Complex> spectrum) {
    method_->forward(values, spectrum);
}

}  // namespace fumon
