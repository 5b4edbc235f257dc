#pragma once

#include <cstddef>
#include <vector>

namespace fumon {

/// Real discrete Fourier transforms of `length` points, of 8 rows at a time: F(m) = Σ_i f(i)
/// exp(−2πi·mi/n), by Stockham's mixed-radix method (radices 4, 2, 3, 5; other primes r cost r² per
/// butterfly). Two rows travel as one complex one. The same bits on every CPU.
class ColumnTransform {
  public:
    static constexpr std::size_t rows = 8;

    explicit ColumnTransform(int length);

    /// Working memory of one thread.
    struct Scratch {
        std::vector<double> from;
        std::vector<double> to;
    };
    [[nodiscard]] Scratch scratch() const;

    /// Values of point i at values[i·stride … + 8). Mode m's real parts go to
    /// real[m·spectrum_stride … + 8), its imaginary ones alike, for m = 0 … length/2.
    void forward(const double* values, std::size_t stride, double* real, double* imaginary,
                 std::size_t spectrum_stride, Scratch& scratch) const;

    /// The inverse, but for a factor of length.
    void backward(const double* real, const double* imaginary, std::size_t spectrum_stride,
                  double* values, std::size_t stride, Scratch& scratch) const;

  private:
    void transform(Scratch& scratch) const;

    std::size_t length_;
    std::vector<std::size_t> radices_;
    std::vector<double> cosine_;  ///< of 2πj/length
    std::vector<double> sine_;
};

}  // namespace fumon
