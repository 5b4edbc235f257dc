#include "numerics/fourier_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/measured_beds.h"

namespace fumon {
namespace {

constexpr std::size_t rows = FourierTransform::rows;
constexpr std::size_t stride = rows + 3;  // what lies between is not touched
constexpr double untouched = 77.0;

class TransformLength : public ::testing::TestWithParam<std::size_t> {
  protected:
    /// 8 rows of noise, point by point.
    static std::vector<double> noise(std::size_t length) {
        const Grid bed = test::noise(static_cast<int>(length), static_cast<int>(rows), 3);
        std::vector<double> values(length * stride, untouched);
        for (std::size_t i = 0; i < length; ++i) {
            for (std::size_t row = 0; row < rows; ++row)
                values[i * stride + row] = bed.row(static_cast<int>(row))[i];
        }
        return values;
    }
};

TEST_P(TransformLength, AgreesWithThePlainSum) {
    const std::size_t length = GetParam();
    const std::vector<double> values = noise(length);
    std::vector<double> real((length / 2 + 1) * stride);
    std::vector<double> imaginary(real.size());
    const FourierTransform transform(length);
    FourierTransform::Scratch scratch = transform.scratch();
    transform.forward(values.data(), stride, real.data(), imaginary.data(), stride, scratch);
    // An object and its scratch serve again and again.
    transform.forward(values.data(), stride, real.data(), imaginary.data(), stride, scratch);
    const double tolerance = 1e-11 * std::sqrt(static_cast<double>(length));
    for (std::size_t m = 0; m <= length / 2; m += 1 + length / 50) {
        for (std::size_t row = 0; row < rows; ++row) {
            std::complex<double> expected;
            for (std::size_t i = 0; i < length; ++i) {
                const double share =
                    static_cast<double>(m * i % length) / static_cast<double>(length);
                expected += values[i * stride + row] * std::polar(1.0, -test::turn * share);
            }
            ASSERT_NEAR(real[m * stride + row], expected.real(), tolerance) << m << ", " << row;
            ASSERT_NEAR(imaginary[m * stride + row], expected.imag(), tolerance)
                << m << ", " << row;
        }
    }
}

TEST_P(TransformLength, ComesBack) {
    const std::size_t length = GetParam();
    const std::vector<double> values = noise(length);
    std::vector<double> real((length / 2 + 1) * stride);
    std::vector<double> imaginary(real.size());
    const FourierTransform transform(length);
    FourierTransform::Scratch scratch = transform.scratch();
    transform.forward(values.data(), stride, real.data(), imaginary.data(), stride, scratch);
    std::vector<double> back(values.size(), untouched);
    transform.backward(real.data(), imaginary.data(), stride, back.data(), stride, scratch);
    const auto n = static_cast<double>(length);
    for (std::size_t i = 0; i < back.size(); ++i) {
        if (i % stride < rows)
            ASSERT_NEAR(back[i] / n, values[i], 1e-12 * std::sqrt(n)) << i;
        else
            ASSERT_EQ(back[i], untouched) << i;
    }
}

// Every radix alone and with others; 131, 262, 4099 and 10007 have a prime factor above 127.
INSTANTIATE_TEST_SUITE_P(All, TransformLength,
                         ::testing::Values(1, 2, 3, 4, 5, 31, 37, 74, 100, 127, 131, 262, 360, 512,
                                           4099, 10007));

}  // namespace
}  // namespace fumon
