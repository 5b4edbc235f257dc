#include "base/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"
#include "support/multiversion.h"
#include "support/ulps.h"

namespace fumon {
namespace {

using test::infinity;
using test::ulps_off;

template <class Ours, class Truth>
double worst(Ours ours, Truth truth, double low, double high) {
    RandomStream stream(1, 0, 0, Purpose::initial_bed);
    double largest = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const double x = low + (high - low) * stream.uniform();
        largest = std::max(largest, ulps_off(ours(x), truth(static_cast<long double>(x))));
    }
    return largest;
}

TEST(Elementary, ExpIsWithinTwoUnitsInTheLastPlace) {
    const auto truth = [](long double x) { return std::exp(x); };
    EXPECT_LE(worst(elementary::exp, truth, -1.0, 1.0), 2.0);
    EXPECT_LE(worst(elementary::exp, truth, -700.0, 709.0), 2.0);
    EXPECT_LE(worst(elementary::exp, truth, -745.0, -708.0), 2.0) << "subnormal results";
}

TEST(Elementary, LogIsWithinTwoUnitsInTheLastPlace) {
    const auto truth = [](long double x) { return std::log(x); };
    EXPECT_LE(worst(elementary::log, truth, 0.5, 2.0), 2.0);
    EXPECT_LE(worst(elementary::log, truth, 1e-300, 1e300), 2.0);
    EXPECT_LE(worst(elementary::log, truth, 0.0, 1e-308), 2.0) << "subnormal arguments";
}

/// x^1.8 y^2.1 as models take powers of squares: exp(1.8/2 ln x² + 2.1/2 ln y²).
FUMON_MULTIVERSION void powers_of_all(const double* in, double* out, int count) {
    for (int i = 0; i < count; ++i) {
        out[i] = elementary::exp(0.9 * elementary::log_of_normal(in[i] * in[i]) +
                                 1.05 * elementary::log_of_normal(in[i]));
    }
}

TEST(Elementary, PowersByLogarithmsKeepThirteenDigits) {
    std::vector<double> in(4001);
    RandomStream stream(3, 0, 0, Purpose::initial_bed);
    for (double& x : in) x = elementary::exp(-20.0 + 25.0 * stream.uniform());
    std::vector<double> out(in.size());
    powers_of_all(in.data(), out.data(), static_cast<int>(in.size()));
    for (std::size_t i = 0; i < in.size(); ++i) {
        const long double truth = std::pow(static_cast<long double>(in[i]), 2.85L);
        ASSERT_LT(std::fabs(static_cast<double>(out[i] / truth - 1.0L)), 1e-13) << in[i];
    }
}

TEST(Elementary, LogarithmsOfNormalNumbersAreThoseOfLog) {
    for (const double x : {0x1p-1022, 1e-300, 0.1, 0.70710678118654752, 0.70710678118654757, 1.0,
                           1.4142135623730951, 1e300, 0x1.fffffffffffffp1023}) {
        EXPECT_EQ(elementary::log_of_normal(x), elementary::log(x)) << x;
        EXPECT_NEAR(elementary::log(x), static_cast<double>(std::log(static_cast<long double>(x))),
                    1e-15 * (1.0 + std::fabs(elementary::log(x))))
            << x;
    }
}

TEST(Elementary, TanhIsWithinThreeUnitsInTheLastPlace) {
    const auto truth = [](long double x) { return std::tanh(x); };
    EXPECT_LE(worst(elementary::tanh, truth, -1e-5, 1e-5), 2.0);
    EXPECT_LE(worst(elementary::tanh, truth, -1.0, 1.0), 3.0);
    EXPECT_LE(worst(elementary::tanh, truth, -30.0, 30.0), 3.0);
}

TEST(Elementary, SineAndCosineAreWithinTwoUnitsInTheLastPlace) {
    const auto sine = [](long double x) { return std::sin(x); };
    const auto cosine = [](long double x) { return std::cos(x); };
    EXPECT_LE(worst(elementary::sin, sine, -0.8, 0.8), 2.0);
    EXPECT_LE(worst(elementary::sin, sine, -1000.0, 1000.0), 2.0);
    EXPECT_LE(worst(elementary::cos, cosine, -0.8, 0.8), 2.0);
    EXPECT_LE(worst(elementary::cos, cosine, -1000.0, 1000.0), 2.0);
}

TEST(Elementary, SpecialValues) {
    EXPECT_EQ(elementary::exp(0.0), 1.0);
    EXPECT_EQ(elementary::exp(infinity), infinity);
    EXPECT_EQ(elementary::exp(-infinity), 0.0);
    EXPECT_EQ(elementary::exp(1000.0), infinity);
    EXPECT_TRUE(std::isnan(elementary::exp(NAN)));
    EXPECT_EQ(elementary::log(1.0), 0.0);
    EXPECT_EQ(elementary::log(0.0), -infinity);
    EXPECT_EQ(elementary::log(infinity), infinity);
    EXPECT_TRUE(std::isnan(elementary::log(-1.0)));
    EXPECT_TRUE(std::isnan(elementary::log(NAN)));
    EXPECT_EQ(elementary::tanh(0.0), 0.0);
    EXPECT_TRUE(std::signbit(elementary::tanh(-0.0)));
    EXPECT_EQ(elementary::tanh(infinity), 1.0);
    EXPECT_EQ(elementary::tanh(-infinity), -1.0);
    EXPECT_TRUE(std::isnan(elementary::tanh(NAN)));
    EXPECT_EQ(elementary::sin(0.0), 0.0);
    EXPECT_EQ(elementary::cos(0.0), 1.0);
    EXPECT_TRUE(std::isnan(elementary::sin(infinity)));
}

FUMON_MULTIVERSION void tanh_of_all(const double* in, double* out, int count) {
    for (int i = 0; i < count; ++i) out[i] = elementary::tanh(in[i]);
}

TEST(Elementary, VectorisedLoopsGiveTheSameBits) {
    std::vector<double> in(1003);
    RandomStream stream(2, 0, 0, Purpose::initial_bed);
    for (double& x : in) x = 20.0 * (stream.uniform() - 0.5);
    std::vector<double> out(in.size());
    tanh_of_all(in.data(), out.data(), static_cast<int>(in.size()));
    for (std::size_t i = 0; i < in.size(); ++i) ASSERT_EQ(out[i], elementary::tanh(in[i])) << in[i];
}

}  // namespace
}  // namespace fumon
