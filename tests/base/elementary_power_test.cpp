#include "base/elementary_power.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "support/ulps.h"

namespace fumon {
namespace {

using test::infinity;
using test::ulps_off;

struct PowerRange {
    const char* name;
    double (*base)(RandomStream&);
    double (*exponent)(RandomStream&, double base);
};

double anywhere(RandomStream& random) {
    return std::exp(1400.0 * (random.uniform() - 0.5));
}
/// A power up to e^±745: from the smallest subnormal number to the largest of all.
double any_power(RandomStream& random, double base) {
    return (2.0 * random.uniform() - 1.0) * 745.0 / std::log(base);
}

void PrintTo(const PowerRange& range, std::ostream* out) {
    *out << range.name;
}

class Powers : public testing::TestWithParam<PowerRange> {};

/// long double has 11 bits more; what it rounds away is the allowance.
TEST_P(Powers, AreRoundedToTheNearestDouble) {
    RandomStream random(5, 0, 0, Purpose::initial_bed);
    for (int i = 0; i < 30000; ++i) {
        const double base = GetParam().base(random);
        const double exponent = GetParam().exponent(random, base);
        if (!std::isfinite(exponent)) continue;
        const long double truth =
            std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
        ASSERT_LE(ulps_off(elementary::pow(base, exponent), truth), 0.5 + 0x1p-9)
            << base << "^" << exponent;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Powers,
    testing::Values(
        PowerRange{"Everyday", [](RandomStream& random) { return 10.0 * random.uniform(); },
                   [](RandomStream& random, double) { return 20.0 * random.uniform() - 10.0; }},
        PowerRange{"Whole",
                   [](RandomStream& random) { return std::floor(1000.0 * random.uniform()) + 1.0; },
                   [](RandomStream& random, double) {
                       return std::floor(40.0 * random.uniform()) - 20.0;
                   }},
        PowerRange{"AllMagnitudes", anywhere, any_power},
        PowerRange{"NearOneToLargeExponents",
                   [](RandomStream& random) {
                       const double digits = std::floor(52.0 * random.uniform());
                       return 1.0 + (random.uniform() - 0.5) * std::exp2(-digits);
                   },
                   any_power},
        PowerRange{"Subnormal", [](RandomStream& random) { return 10.0 * random.uniform(); },
                   [](RandomStream& random, double base) {
                       return -(708.0 + 37.5 * random.uniform()) / std::log(base);
                   }}),
    [](const auto& chosen) { return chosen.param.name; });

TEST(Power, OfTenAreTheDecimalNumbers) {
    for (int exponent = -323; exponent <= 308; ++exponent) {
        const double truth = std::stod("1e" + std::to_string(exponent < -307 ? -307 : exponent));
        if (exponent >= -307) {
            EXPECT_EQ(elementary::pow(10.0, exponent), truth) << exponent;
            EXPECT_EQ(elementary::log10(truth), exponent);
        }
    }
    EXPECT_EQ(elementary::pow(10.0, -320.0), 1e-320) << "a subnormal number";
}

TEST(Power, ExactOnesAreExact) {
    EXPECT_EQ(elementary::pow(4.0, 1.5), 8.0);
    EXPECT_EQ(elementary::pow(0.0625, -0.75), 8.0);
    EXPECT_EQ(elementary::pow(1.0 + 0x1p-20, 2.0), 1.0 + 0x1p-19 + 0x1p-40);
    EXPECT_EQ(elementary::pow(3.0, 33.0), 5559060566555523.0);
    EXPECT_EQ(elementary::pow(-3.0, 3.0), -27.0);
    EXPECT_EQ(elementary::pow(2.0, -1074.0), 0x1p-1074);
}

TEST(Power, HalfwayOnesGoToTheEvenNeighbour) {
    EXPECT_EQ(elementary::pow(2.0, -1075.0), 0.0) << "half the smallest number";
    // Odd numbers of 54 bits, which long double holds.
    for (const double base : {262143.0, 206999.0, 189813.0}) {
        const long double power = static_cast<long double>(base) * base * base;
        ASSERT_EQ(elementary::pow(base, 3.0), static_cast<double>(power)) << base;
    }
    EXPECT_EQ(elementary::pow(928.0, 11.0),
              static_cast<double>(std::ldexp(std::pow(29.0L, 11.0L), 55)));
}

TEST(Power, SpecialValuesAreThoseOfTheStandard) {
    const std::vector<double> values = {
        0.0,     -0.0,         1.0,          -1.0,           2.0, -2.0,  3.0,    -3.0,
        0.5,     -0.5,         infinity,     -infinity,      NAN, 1e300, -1e300, 1e-310,
        -1e-310, 0x1p53 + 2.0, 0x1p52 + 1.0, -(0x1p52 + 1.0)};
    const auto special = [](double x) {
        return x == 0.0 || x == 1.0 || x == -1.0 || !std::isfinite(x);
    };
    int compared = 0;
    for (const double base : values) {
        for (const double exponent : values) {
            const double truth = std::pow(base, exponent);
            if (!special(truth)) continue;
            ++compared;
            const double ours = elementary::pow(base, exponent);
            if (std::isnan(truth)) {
                EXPECT_TRUE(std::isnan(ours)) << base << "^" << exponent;
            } else {
                EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(truth))
                    << base << "^" << exponent;
            }
        }
    }
    EXPECT_GT(compared, 250);
}

TEST(DecimalLogarithm, IsRoundedToTheNearestDouble) {
    RandomStream random(6, 0, 0, Purpose::initial_bed);
    for (int i = 0; i < 30000; ++i) {
        const double x = i % 2 == 0 ? anywhere(random) : 0.5 + random.uniform();
        const long double truth = std::log10(static_cast<long double>(x));
        ASSERT_LE(ulps_off(elementary::log10(x), truth), 0.5 + 0x1p-9) << x;
    }
    EXPECT_EQ(elementary::log10(0.0), -infinity);
    EXPECT_EQ(elementary::log10(infinity), infinity);
    EXPECT_EQ(elementary::log10(1.0), 0.0);
    EXPECT_TRUE(std::isnan(elementary::log10(-1.0)));
    EXPECT_NEAR(elementary::log10(1e-320), -320.0, 1e-3);
}

}  // namespace
}  // namespace fumon
