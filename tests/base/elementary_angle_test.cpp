#include "base/elementary_angle.h"

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

/// Vectors of every direction and length.
template <class Check>
void for_vectors(Check check) {
    RandomStream random(7, 0, 0, Purpose::initial_bed);
    for (int i = 0; i < 100000; ++i) {
        const double length = i % 2 == 0 ? 1.0 : std::exp(1400.0 * (random.uniform() - 0.5));
        const double slope = std::exp((i % 4 < 2 ? 4.0 : 60.0) * (random.uniform() - 0.5));
        const double x = i % 3 == 0 ? -length : length;
        const double y = i % 5 < 2 ? -length * slope : length * slope;
        if (std::isfinite(y)) check(x, y);
    }
}

TEST(ElementaryAngle, IsWithinTwoUnitsInTheLastPlace) {
    for_vectors([](double x, double y) {
        const long double truth =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        ASSERT_LE(ulps_off(elementary::atan2(y, x), truth), 2.0) << x << ", " << y;
    });
}

TEST(ElementaryAngle, ArcTangentIsWithinTwoUnitsInTheLastPlace) {
    for_vectors([](double, double y) {
        ASSERT_LE(ulps_off(elementary::atan(y), std::atan(static_cast<long double>(y))), 2.0) << y;
    });
}

TEST(ElementaryAngle, RoughArcTangentIsWithinAHundredThousandth) {
    for (int i = 0; i <= 1000; ++i) {
        const double t = 1e-3 * i;
        ASSERT_NEAR(elementary::rough_atan(t), std::atan(t), 1.2e-5) << t;
        ASSERT_NEAR(elementary::rough_atan(static_cast<float>(t)), std::atan(t), 1.2e-5) << t;
    }
}

TEST(ElementaryAngle, LengthIsWithinOneUnitInTheLastPlace) {
    for_vectors([](double x, double y) {
        const long double truth =
            std::hypot(static_cast<long double>(x), static_cast<long double>(y));
        ASSERT_LE(ulps_off(elementary::hypot(x, y), truth), 1.0) << x << ", " << y;
    });
    EXPECT_EQ(elementary::hypot(3.0, -4.0), 5.0);
    EXPECT_EQ(elementary::hypot(0x3p700, 0x4p700), 0x5p700);
    EXPECT_EQ(elementary::hypot(0x3p-1070, 0x4p-1070), 0x5p-1070);
    EXPECT_EQ(elementary::hypot(0.0, -0.0), 0.0);
    EXPECT_EQ(elementary::hypot(NAN, -infinity), infinity);
    EXPECT_TRUE(std::isnan(elementary::hypot(NAN, 1.0)));
}

TEST(ElementaryAngle, SpecialValuesAreThoseOfTheStandard) {
    const std::vector<double> values = {0.0, -0.0, 1.0, -1.0, infinity, -infinity, NAN};
    for (const double y : values) {
        for (const double x : values) {
            const double truth = std::atan2(y, x);
            const double ours = elementary::atan2(y, x);
            if (std::isnan(truth)) {
                EXPECT_TRUE(std::isnan(ours)) << y << ", " << x;
            } else {
                EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(truth))
                    << y << ", " << x;
            }
        }
    }
}

}  // namespace
}  // namespace fumon
