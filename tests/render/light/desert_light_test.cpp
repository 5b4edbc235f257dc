#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "base/units.h"
#include "render/light/light.h"

namespace fumon {
namespace {

Light desert_light(double elevation, Aerosol aerosol = Aerosol::desert) {
    SunSettings sun;
    sun.elevation = elevation;
    return make_atmospheric_light(sun, Planet::earth, 0.0, aerosol);
}

double luminance_of(const glm::dvec3& colour) {
    return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

/// Of the sky, degrees above the horizon and from the sun's azimuth.
glm::dvec3 radiance(const Light& light, double elevation, double azimuth) {
    const auto nearest = [](double root, int count) {
        return static_cast<std::size_t>(std::lround(root * (count - 1)));
    };
    const std::size_t row = nearest(std::sqrt(elevation / 90.0), light.sky_rows);
    const std::size_t column = nearest(std::sqrt(azimuth / 180.0), light.sky_columns);
    return glm::dvec3(
        glm::vec3(light.sky_texels.at(row * static_cast<std::size_t>(light.sky_columns) + column)));
}

/// In the CIE's (u, v) of 1960, of linear sRGB.
glm::dvec2 uv_of_srgb(const glm::dvec3& c) {
    const double x = glm::dot(c, glm::dvec3(0.41246, 0.35758, 0.18044));
    const double y = glm::dot(c, glm::dvec3(0.21267, 0.71515, 0.07218));
    const double z = glm::dot(c, glm::dvec3(0.01933, 0.11919, 0.95030));
    return glm::dvec2(4.0 * x, 6.0 * y) / (x + 15.0 * y + 3.0 * z);
}

/// How far a colour lies off the CIE's daylight locus: towards green above 0.
double above_daylight(const glm::dvec3& colour) {
    const glm::dvec2 uv = uv_of_srgb(colour);
    double nearest = 1.0;
    double side = 0.0;
    for (double kelvin = 4000.0; kelvin < 25000.0; kelvin *= 1.005) {
        const double m = 1e3 / kelvin;
        const double x = kelvin <= 7000.0 ? ((-4.6070 * m + 2.9678) * m + 0.09911) * m + 0.244063
                                          : ((-2.0064 * m + 1.9018) * m + 0.24748) * m + 0.237040;
        const double y = (-3.0 * x + 2.870) * x - 0.275;
        const glm::dvec2 daylight = glm::dvec2(4.0 * x, 6.0 * y) / (-2.0 * x + 12.0 * y + 3.0);
        if (const double away = glm::distance(daylight, uv); away < nearest) {
            nearest = away;
            side = uv.y - daylight.y;
        }
    }
    return std::copysign(nearest, side);
}

/// Skies measured by day lie along the locus of daylight; the air of molecules alone is greener
/// above the horizon.
TEST(DesertLight, TheSkyAboveTheHorizonIsOfDaylightsColours) {
    for (const double sun : {10.0, 20.0, 45.0}) {
        const Light light = desert_light(sun);
        for (const double azimuth : {60.0, 90.0, 180.0}) {
            for (const double elevation : {1.2, 2.0, 5.0, 10.0}) {
                EXPECT_NEAR(above_daylight(radiance(light, elevation, azimuth)), 0.0, 0.0025)
                    << "sun " << sun << ", " << elevation << " up, " << azimuth << " aside";
            }
        }
    }
    EXPECT_GT(above_daylight(radiance(desert_light(10.0, Aerosol::thin), 2.0, 180.0)), 0.003);
}

/// From blue overhead to pale above the horizon, with no dark band there.
TEST(DesertLight, TheSkyTurnsPaleAndBrightTowardTheHorizon) {
    for (const double sun : {10.0, 20.0, 45.0}) {
        const Light light = desert_light(sun);
        const auto blue = [&](double elevation) {
            const glm::dvec3 c = radiance(light, elevation, 120.0);
            return c.b / c.r;
        };
        EXPECT_GT(blue(90.0), 1.3 * blue(10.0)) << sun;
        EXPECT_GT(blue(10.0), 1.3 * blue(2.0)) << sun;
        EXPECT_NEAR(blue(2.0), 0.95, 0.35) << sun;
        const double low = luminance_of(radiance(light, 1.2, 120.0));
        EXPECT_GT(low, 0.7 * luminance_of(radiance(light, 5.0, 120.0))) << sun;
        EXPECT_GT(low, 2.0 * luminance_of(radiance(light, 60.0, 150.0))) << sun;
    }
}

/// Level sand of the drawn reflectance in the sun, times π.
glm::dvec3 sunlit_sand(const Light& light) {
    const glm::dvec3 sand(0.615, 0.436, 0.262);
    return sand *
           (glm::dvec3(light.sun) * static_cast<double>(light.to_sun.z) + glm::dvec3(light.sky));
}

/// Never a band of grey above the ground: away from the sun too the horizon of a clear desert is as
/// bright as sand in a low sun, and nearly so in a high one; without much colour of its own.
TEST(DesertLight, TheHorizonIsAsBrightAsSandInTheSun) {
    for (const double sun : {5.0, 10.0, 17.0, 30.0, 45.0, 60.0}) {
        const Light light = desert_light(sun);
        const double sand = luminance_of(sunlit_sand(light));
        for (const double azimuth : {60.0, 90.0, 110.0, 180.0}) {
            const glm::dvec3 horizon = radiance(light, 1.2, azimuth);
            const double share = luminance_of(horizon) / sand;
            EXPECT_GT(share, sun < 20.0 ? 1.3 : 0.75) << sun << ", " << azimuth << " aside";
            if (sun < 12.0 || azimuth < 80.0) continue;
            EXPECT_NEAR(horizon.b / horizon.r, 0.97, 0.13) << sun << ", " << azimuth;
        }
    }
}

/// Between the CIE's clear skies of low and high turbidity (ISO 15469, types 12 and 13), across the
/// sun; a little above the latter, as a desert's zenith is dark, where the sun is high.
TEST(DesertLight, TheHorizonStandsToTheZenithAsInClearSkies) {
    const auto standard = [](double sun, double c, double d, double e, double gradation) {
        const auto indicatrix = [&](double angle) {
            return 1.0 + c * (std::exp(d * angle) - std::exp(d * 90.0 * degree)) +
                   e * std::cos(angle) * std::cos(angle);
        };
        return gradation * indicatrix(90.0 * degree) / indicatrix((90.0 - sun) * degree);
    };
    for (const double sun : {8.0, 12.0, 17.0}) {
        const Light light = desert_light(sun);
        const double found =
            luminance_of(radiance(light, 1.2, 90.0)) / luminance_of(radiance(light, 90.0, 90.0));
        EXPECT_GT(found, standard(sun, 10.0, -3.0, 0.45, 1.0 / (1.0 - std::exp(-0.32)))) << sun;
        EXPECT_LT(found, standard(sun, 16.0, -3.0, 0.3, 1.0 / (1.0 - std::exp(-0.15)))) << sun;
    }
}

/// Open shade against level ground in the sun: about a third with the sun at 10 degrees, a fifth to
/// an eighth at 20, a tenth at 45.
TEST(DesertLight, ShadeHasItsShareOfTheLight) {
    const auto share = [](double elevation) {
        const Light light = desert_light(elevation);
        const double sun = luminance_of(glm::dvec3(light.sun)) * std::sin(elevation * degree);
        const double sky = luminance_of(glm::dvec3(light.sky));
        return sky / (sun + sky);
    };
    EXPECT_NEAR(share(10.0), 1.0 / 3.0, 0.05);
    EXPECT_GT(share(20.0), 1.0 / 8.0);
    EXPECT_LT(share(20.0), 1.0 / 5.0);
    EXPECT_GT(share(45.0), 1.0 / 12.0);
    EXPECT_LT(share(45.0), 1.0 / 9.0);
}

/// What hides the sun hides its aureole too: slopes that turn away from it do not lose light by it.
TEST(DesertLight, ShadeIsNotLitByTheAureole) {
    const Light light = desert_light(10.0);
    const float x = -0.53F;
    const float t = 0.152F;
    const glm::vec3 lean = x * (light.sky_lean[0] + x * light.sky_lean[1] + t * light.sky_lean[3]) +
                           t * light.sky_lean[2];
    EXPECT_GT(lean.g, -0.05F);
    EXPECT_GT(light.sky.b, 2.2F * light.sky.r) << "blue shade";
}

TEST(DesertLight, ClearAirIsThatOfOthers) {
    SunSettings sun;
    const Light usual = make_atmospheric_light(sun);
    EXPECT_EQ(usual.sky_texels,
              make_atmospheric_light(sun, Planet::earth, 0.0, Aerosol::thin).sky_texels);
    const Light mars = make_atmospheric_light(sun, Planet::mars);
    EXPECT_EQ(mars.sky_texels,
              make_atmospheric_light(sun, Planet::mars, 0.0, Aerosol::desert).sky_texels);
}

}  // namespace
}  // namespace fumon
