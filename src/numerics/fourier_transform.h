#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace fumon {

/// The discrete Fourier transform of n complex values, F(k) = Σ_x f(x) exp(−2πi·kx/n), in
/// O(n log n) for every n: by Stockham's mixed-radix method where n has no prime factor above 31,
/// else as a convolution over a power of two (Bluestein 1970). Relative errors are near 1e-15, or
/// 1e-14 by convolution; the same bits on every CPU. Tables are made once; an object serves one
/// thread.
class FourierTransform {
  public:
    explicit FourierTransform(std::size_t length);
    ~FourierTransform();
    FourierTransform(const FourierTransform&) = delete;
    FourierTransform& operator=(const FourierTransform&) = delete;

    /// Both of the transform's length, and not the same memory.
    void forward(std::span<const std::complex<double>> values,
                 std::span<std::complex<double>> spectrum);

  private:
    class Method;
    class MixedRadix;
    class Convolution;
    std::unique_ptr<Method> method_;
};

}  // namespace fumon
