#include "render/light/sun_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/light/light.h"

namespace fumon {
namespace {

SunSettings sun_at(double azimuth, double elevation, double diameter) {
    SunSettings settings;
    settings.azimuth = azimuth;
    settings.elevation = elevation;
    settings.diameter = diameter;
    return settings;
}

double tangent(double degrees) {
    return std::tan(degrees * M_PI / 180.0);
}

/// A wall of height 10 through the middle, across the sun's direction.
Field<float> wall(int n, bool along_x) {
    Field<float> heights(n, n, 0.0F);
    for (int i = 0; i < n; ++i) (along_x ? heights(i, n / 2) : heights(n / 2, i)) = 10.0F;
    return heights;
}

TEST(SunSweep, AWallsShadowHasItsLengthAndPenumbra) {
    constexpr int n = 201;
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
        for (const float dx : {1.0F, 0.5F}) {
            const bool along_x = azimuth == 0.0 || azimuth == 180.0;
            const float dy = 0.75F;
            const Field<float> lit =
                sun_visibility(wall(n, along_x), dx, dy, sun_direction(sun_at(azimuth, 25.0, 6.0)));
            const double cell = along_x ? dy : dx;
            const int away = azimuth == 0.0 || azimuth == 90.0 ? -1 : 1;  // from the sun
            for (int k = 1; k < n / 2 - 1; ++k) {
                const double distance = k * cell;
                const double near = 10.0 / tangent(28.0);  // umbra ends
                const double far = 10.0 / tangent(22.0);   // full sun begins
                const int at = n / 2 + away * k;
                const float value = along_x ? lit(n / 2, at) : lit(at, n / 2);
                if (distance < near - 1e-3) {
                    EXPECT_FLOAT_EQ(value, 0.0F) << azimuth << " " << distance;
                } else if (distance > far + 1e-3) {
                    EXPECT_FLOAT_EQ(value, 1.0F) << azimuth << " " << distance;
                } else {
                    const double upper = 10.0 - distance * tangent(28.0);
                    const double lower = 10.0 - distance * tangent(22.0);
                    EXPECT_NEAR(value, (0.0 - upper) / (lower - upper), 2e-3);
                }
                const int towards = n / 2 - away * k;
                EXPECT_FLOAT_EQ(along_x ? lit(n / 2, towards) : lit(towards, n / 2), 1.0F);
            }
        }
    }
}

TEST(SunSweep, ATowersShadowPointsAwayFromTheSunAtAnyAzimuth) {
    constexpr int n = 161;
    for (int degrees = 5; degrees < 360; degrees += 23) {
        const double azimuth = degrees;
        Field<float> heights(n, n, 0.0F);
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x) heights(n / 2 + x, n / 2 + y) = 20.0F;
        const Field<float> lit =
            sun_visibility(heights, 1.0F, 1.0F, sun_direction(sun_at(azimuth, 30.0, 1.0)));
        const double east = std::sin(azimuth * M_PI / 180.0);
        const double north = std::cos(azimuth * M_PI / 180.0);
        const auto along = [&](double distance) {
            return lit(n / 2 - static_cast<int>(std::lround(distance * east)),
                       n / 2 - static_cast<int>(std::lround(distance * north)));
        };
        EXPECT_LT(along(15.0), 0.05F) << azimuth;
        EXPECT_LT(along(27.0), 0.05F) << azimuth;
        EXPECT_GT(along(45.0), 0.95F) << azimuth;
        EXPECT_GT(along(-15.0), 0.95F) << azimuth;
    }
}

TEST(SunSweep, APlainIsLit) {
    const Field<float> lit = sun_visibility(Field<float>(17, 9, 3.0F), 1.0F, 2.0F,
                                            sun_direction(sun_at(123.0, 5.0, 2.5)));
    EXPECT_FLOAT_EQ(*std::min_element(lit.values().begin(), lit.values().end()), 1.0F);
}

TEST(SunSweep, ASteepLeeSlopeIsDark) {
    Field<float> heights(50, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 50; ++x) heights(x, y) = 50.0F - static_cast<float>(x);
    const Field<float> lit =
        sun_visibility(heights, 1.0F, 1.0F, sun_direction(sun_at(270.0, 30.0, 2.0)));
    EXPECT_FLOAT_EQ(lit(25, 2), 0.0F);  // 45° down, away from a sun at 30°
}

/// Where the shadow of a wall ends on a steep face: shares beyond 0 and 1 place it inside a cell,
/// wherever the face stands.
TEST(SunSweep, SharesBeyondTheEndsFindAnEdgeInsideACell) {
    constexpr int n = 64;
    constexpr float rise = 1.5F;  // of the face, a cell
    const double slope = tangent(30.0);
    for (const float shift : {0.0F, 0.2F, 0.4F, 0.6F, 0.8F}) {
        Field<float> heights(n, 3, 0.0F);
        const float foot = 30.0F + shift;
        for (int y = 0; y < 3; ++y) {
            heights(10, y) = 20.0F;
            for (int x = 30; x < n; ++x)
                heights(x, y) = rise * std::max(static_cast<float>(x) - foot, 0.0F);
        }
        const Field<float> shares = sun_visibility(
            heights, 1.0F, 1.0F, sun_direction(sun_at(270.0, 30.0, 0.2)), {-50.0F, 50.0F});
        int x = 31;
        while (shares(x, 1) < 0.5F) ++x;
        const float edge =
            static_cast<float>(x) - (shares(x, 1) - 0.5F) / (shares(x, 1) - shares(x - 1, 1));
        // 20 − slope·(edge − 10) = rise·(edge − foot)
        const double expected = (20.0 + slope * 10.0 + rise * foot) / (rise + slope);
        EXPECT_NEAR(edge, expected, 0.05) << shift;
    }
}

TEST(SunSweep, APeriodicBedIsLitTheSameWhereverItIsCut) {
    const auto bumps = [](int east, int north) {
        Field<float> heights(37, 23);
        for (int y = 0; y < 23; ++y) {
            for (int x = 0; x < 37; ++x) {
                const int u = (x + east) % 37;
                const int v = (y + north) % 23;
                heights(x, y) = 0.3F * static_cast<float>((u * u * 7 + v * v * 5 + u * v) % 11);
            }
        }
        return heights;
    };
    for (const double azimuth : {10.0, 80.0, 130.0, 200.0, 290.0, 330.0}) {
        for (const double elevation : {1.0, 8.0, 20.0}) {
            const SunDirection sun = sun_direction(sun_at(azimuth, elevation, 1.0));
            const auto lit = [&](int east, int north) {
                return sun_visibility(bumps(east, north), 1.0F, 1.0F, sun, {},
                                      LatticeBorder::periodic);
            };
            const Field<float> here = lit(0, 0);
            const Field<float> there = lit(14, 9);
            for (int y = 0; y < 23; ++y) {
                for (int x = 0; x < 37; ++x)
                    ASSERT_EQ(there(x, y), here((x + 14) % 37, (y + 9) % 23))
                        << azimuth << ' ' << elevation << ' ' << x << ' ' << y;
            }
        }
    }
}

}  // namespace
}  // namespace fumon
