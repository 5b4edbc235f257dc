#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace fumon {

/// Discrete Fourier transforms of real rows of `length` points, 8 rows at a time: F(m) =
/// Σ_i f(i) exp(−2πi·mi/n), m = 0 … n/2, by Stockham's mixed-radix method (Cochran et al. 1967)
/// with the radices 4, 5, 2 and 3; another prime r up to 127 costs r² per butterfly, and where n
/// has a larger one the transform is a convolution over a power of two (Bluestein 1970). Two rows
/// travel as one complex one. Relative errors are near 1e-15, or 1e-14 by convolution; the same
/// bits on every CPU. Tables are made once; threads share an object, each with a Scratch of its
/// own.
class FourierTransform {
  public:
    static constexpr std::size_t rows = 8;

    explicit FourierTransform(std::size_t length);
    ~FourierTransform();
    FourierTransform(const FourierTransform&) = delete;
    FourierTransform& operator=(const FourierTransform&) = delete;

    /// Working memory of one thread: it begins as anything.
    struct Scratch {
        explicit Scratch(std::size_t count)
            : memory(std::make_unique_for_overwrite<double[]>(2 * count)),
              from(memory.get()),
              to(from + count) {}
        std::unique_ptr<double[]> memory;
        double* from;
        double* to;
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
    class Convolution;

    /// Where the points of rows lie.
    template <class Number>
    struct Points {
        Number* first;
        std::size_t step;
    };

    [[nodiscard]] bool in_stages() const { return !convolution_ && !radices_.empty(); }
    void transform(Scratch& scratch) const;
    double* behind_stages(Scratch& scratch) const;
    void run_stages(const Points<const double>& from, const Points<double>& to, bool mirrored,
                    Scratch& scratch) const;

    std::size_t length_;
    std::vector<std::size_t> radices_;
    std::vector<double> cosine_;  ///< of 2πj/length
    std::vector<double> sine_;
    std::unique_ptr<const Convolution> convolution_;  ///< null where the radices will do
};

}  // namespace fumon
