#include "numerics/fourier_transform.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numbers>
#include <utility>

#include "base/elementary.h"
#include "base/multiversion.h"

namespace fumon {

namespace {

/// Up to here a butterfly by the definition is affordable, and more accurate than a convolution.
constexpr std::size_t largest_radix = 127;

constexpr std::size_t half = FourierTransform::rows / 2;
constexpr std::size_t rows = FourierTransform::rows;  // of a point: 4 real parts, 4 imaginary ones

struct Stage {
    std::size_t radix;
    std::size_t parts;   ///< butterflies of one interleaved transform
    std::size_t stride;  ///< interleaved transforms
    std::size_t length;  ///< of the whole
    const double* cosine;
    const double* sine;
};

/// to = (a + ib)·(c − is), point by point.
inline void put_turned(const double* a, const double* b, double c, double s, double* to) {
    for (std::size_t l = 0; l < half; ++l) {
        to[l] = a[l] * c + b[l] * s;
        to[half + l] = b[l] * c - a[l] * s;
    }
}

/// A butterfly of `radix` points by the definition; of 2 and 4 without products.
FUMON_MULTIVERSION
void butterflies_of_four(const Stage& stage, const double* __restrict from, double* __restrict to) {
    const std::size_t reach = stage.parts * stage.stride * rows;
    for (std::size_t p = 0; p < stage.parts; ++p) {
        const std::size_t turn = p * stage.stride;
        for (std::size_t q = 0; q < stage.stride; ++q) {
            const double* x0 = from + (p * stage.stride + q) * rows;
            const double* x1 = x0 + reach;
            const double* x2 = x1 + reach;
            const double* x3 = x2 + reach;
            double* y = to + (4 * p * stage.stride + q) * rows;
            std::array<double, half> a1, b1, a2, b2, a3, b3;
            for (std::size_t l = 0; l < half; ++l) {
                const std::size_t m = l + half;
                const double sum_re = x0[l] + x2[l], sum_im = x0[m] + x2[m];
                const double off_re = x0[l] - x2[l], off_im = x0[m] - x2[m];
                const double odd_re = x1[l] + x3[l], odd_im = x1[m] + x3[m];
                const double cross_re = x1[l] - x3[l], cross_im = x1[m] - x3[m];
                y[l] = sum_re + odd_re;
                y[m] = sum_im + odd_im;
                a2[l] = sum_re - odd_re;
                b2[l] = sum_im - odd_im;
                a1[l] = off_re + cross_im;
                b1[l] = off_im - cross_re;
                a3[l] = off_re - cross_im;
                b3[l] = off_im + cross_re;
            }
            const std::size_t next = stage.stride * rows;
            put_turned(a1.data(), b1.data(), stage.cosine[turn], stage.sine[turn], y + next);
            put_turned(a2.data(), b2.data(), stage.cosine[2 * turn], stage.sine[2 * turn],
                       y + 2 * next);
            put_turned(a3.data(), b3.data(), stage.cosine[3 * turn], stage.sine[3 * turn],
                       y + 3 * next);
        }
    }
}

FUMON_MULTIVERSION
void butterflies_of_five(const Stage& stage, const double* __restrict from, double* __restrict to) {
    const std::size_t reach = stage.parts * stage.stride * rows;
    const std::size_t fifth = stage.length / 5;
    const double c1 = stage.cosine[fifth], s1 = stage.sine[fifth];
    const double c2 = stage.cosine[2 * fifth], s2 = stage.sine[2 * fifth];
    for (std::size_t p = 0; p < stage.parts; ++p) {
        const std::size_t turn = p * stage.stride;
        for (std::size_t q = 0; q < stage.stride; ++q) {
            const double* x0 = from + (p * stage.stride + q) * rows;
            const double* x1 = x0 + reach;
            const double* x2 = x1 + reach;
            const double* x3 = x2 + reach;
            const double* x4 = x3 + reach;
            double* y = to + (5 * p * stage.stride + q) * rows;
            std::array<double, half> a1, b1, a2, b2, a3, b3, a4, b4;
            for (std::size_t l = 0; l < half; ++l) {
                const std::size_t m = l + half;
                const double t1 = x1[l] + x4[l], u1 = x1[m] + x4[m];
                const double t2 = x2[l] + x3[l], u2 = x2[m] + x3[m];
                const double d1 = x1[l] - x4[l], e1 = x1[m] - x4[m];
                const double d2 = x2[l] - x3[l], e2 = x2[m] - x3[m];
                y[l] = x0[l] + (t1 + t2);
                y[m] = x0[m] + (u1 + u2);
                const double r1 = x0[l] + (c1 * t1 + c2 * t2), i1 = x0[m] + (c1 * u1 + c2 * u2);
                const double r2 = x0[l] + (c2 * t1 + c1 * t2), i2 = x0[m] + (c2 * u1 + c1 * u2);
                const double v1 = s1 * d1 + s2 * d2, z1 = s1 * e1 + s2 * e2;
                const double v2 = s2 * d1 - s1 * d2, z2 = s2 * e1 - s1 * e2;
                a1[l] = r1 + z1;
                b1[l] = i1 - v1;
                a4[l] = r1 - z1;
                b4[l] = i1 + v1;
                a2[l] = r2 + z2;
                b2[l] = i2 - v2;
                a3[l] = r2 - z2;
                b3[l] = i2 + v2;
            }
            const std::size_t next = stage.stride * rows;
            put_turned(a1.data(), b1.data(), stage.cosine[turn], stage.sine[turn], y + next);
            put_turned(a2.data(), b2.data(), stage.cosine[2 * turn], stage.sine[2 * turn],
                       y + 2 * next);
            put_turned(a3.data(), b3.data(), stage.cosine[3 * turn], stage.sine[3 * turn],
                       y + 3 * next);
            put_turned(a4.data(), b4.data(), stage.cosine[4 * turn], stage.sine[4 * turn],
                       y + 4 * next);
        }
    }
}

FUMON_MULTIVERSION
void butterflies(const Stage& stage, const double* __restrict from, double* __restrict to) {
    const std::size_t reach = stage.parts * stage.stride * rows;
    const std::size_t part = stage.length / stage.radix;
    for (std::size_t p = 0; p < stage.parts; ++p) {
        for (std::size_t q = 0; q < stage.stride; ++q) {
            const double* x = from + (p * stage.stride + q) * rows;
            for (std::size_t t = 0; t < stage.radix; ++t) {
                std::array<double, half> a{}, b{};
                for (std::size_t j = 0; j < stage.radix; ++j) {
                    const double c = stage.cosine[(j * t) % stage.radix * part];
                    const double s = stage.sine[(j * t) % stage.radix * part];
                    const double* xj = x + j * reach;
                    for (std::size_t l = 0; l < half; ++l) {
                        a[l] += xj[l] * c + xj[l + half] * s;
                        b[l] += xj[l + half] * c - xj[l] * s;
                    }
                }
                const std::size_t turn = p * t * stage.stride;
                put_turned(a.data(), b.data(), stage.cosine[turn], stage.sine[turn],
                           to + ((stage.radix * p + t) * stage.stride + q) * rows);
            }
        }
    }
}

/// z·(c − is) of every point.
FUMON_MULTIVERSION
void turn_points(double* __restrict z, const double* __restrict c, const double* __restrict s,
                 std::size_t points) {
    for (std::size_t i = 0; i < points; ++i, z += rows) {
        for (std::size_t l = 0; l < half; ++l) {
            const double a = z[l], b = z[l + half];
            z[l] = a * c[i] + b * s[i];
            z[l + half] = b * c[i] - a * s[i];
        }
    }
}

/// The conjugate of z·(c + is) of every point.
FUMON_MULTIVERSION
void multiply_and_mirror(double* __restrict z, const double* __restrict c,
                         const double* __restrict s, std::size_t points) {
    for (std::size_t i = 0; i < points; ++i, z += rows) {
        for (std::size_t l = 0; l < half; ++l) {
            const double a = z[l], b = z[l + half];
            z[l] = a * c[i] - b * s[i];
            z[l + half] = -(a * s[i] + b * c[i]);
        }
    }
}

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
        turn_points(scratch.from.data(), cosine_.data(), sine_.data(), length);
        std::fill(scratch.from.begin() + static_cast<std::ptrdiff_t>(length * rows),
                  scratch.from.end(), 0.0);
        padded_.transform(scratch);
        // The inverse transform is the forward one between two conjugations.
        multiply_and_mirror(scratch.from.data(), kernel_real_.data(), kernel_imaginary_.data(),
                            padded_.length_);
        padded_.transform(scratch);
        double* z = scratch.from.data();
        for (std::size_t m = 0; m < length; ++m) {
            for (std::size_t l = half; l < rows; ++l) z[m * rows + l] = -z[m * rows + l];
        }
        turn_points(z, cosine_.data(), sine_.data(), length);
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
    return {std::vector<double>(length_ * rows), std::vector<double>(length_ * rows)};
}

/// Of the 4 complex rows in scratch.from, in place.
void FourierTransform::transform(Scratch& scratch) const {
    if (convolution_) {
        convolution_->transform(scratch);
        return;
    }
    std::size_t remaining = length_;
    std::size_t stride = 1;
    for (const std::size_t radix : radices_) {
        remaining /= radix;
        const Stage stage{radix, remaining, stride, length_, cosine_.data(), sine_.data()};
        if (radix == 4) {
            butterflies_of_four(stage, scratch.from.data(), scratch.to.data());
        } else if (radix == 5) {
            butterflies_of_five(stage, scratch.from.data(), scratch.to.data());
        } else {
            butterflies(stage, scratch.from.data(), scratch.to.data());
        }
        std::swap(scratch.from, scratch.to);
        stride *= radix;
    }
}

void FourierTransform::forward(const double* values, std::size_t stride, double* real,
                               double* imaginary, std::size_t spectrum_stride,
                               Scratch& scratch) const {
    for (std::size_t i = 0; i < length_; ++i) {
        for (std::size_t l = 0; l < rows; ++l) scratch.from[i * rows + l] = values[i * stride + l];
    }
    transform(scratch);
    for (std::size_t m = 0; m <= length_ / 2; ++m) {
        const double* z = &scratch.from[m * rows];
        const double* mirrored = &scratch.from[(m == 0 ? 0 : length_ - m) * rows];
        double* re = real + m * spectrum_stride;
        double* im = imaginary + m * spectrum_stride;
        for (std::size_t l = 0; l < half; ++l) {
            re[l] = 0.5 * (z[l] + mirrored[l]);
            im[l] = 0.5 * (z[l + half] - mirrored[l + half]);
            re[l + half] = 0.5 * (z[l + half] + mirrored[l + half]);
            im[l + half] = 0.5 * (mirrored[l] - z[l]);
        }
    }
}

void FourierTransform::backward(const double* real, const double* imaginary,
                                std::size_t spectrum_stride, double* values, std::size_t stride,
                                Scratch& scratch) const {
    // The inverse of z is the forward transform of i·conj z, likewise turned back: its parts
    // change places.
    for (std::size_t m = 0; m <= length_ / 2; ++m) {
        const double* re = real + m * spectrum_stride;
        const double* im = imaginary + m * spectrum_stride;
        double* z = &scratch.from[m * rows];
        double* mirrored = &scratch.from[(m == 0 ? 0 : length_ - m) * rows];
        for (std::size_t l = 0; l < half; ++l) {
            mirrored[l + half] = re[l] + im[l + half];
            mirrored[l] = re[l + half] - im[l];
            z[l + half] = re[l] - im[l + half];
            z[l] = re[l + half] + im[l];
        }
    }
    transform(scratch);
    for (std::size_t i = 0; i < length_; ++i) {
        for (std::size_t l = 0; l < half; ++l) {
            values[i * stride + l] = scratch.from[i * rows + half + l];
            values[i * stride + half + l] = scratch.from[i * rows + l];
        }
    }
}

}  // namespace fumon
