#include "render/light/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/units.h"
#include "render/sky/sky_tables.h"

namespace fumon {

namespace {

constexpr double level_exposure = 0.80;  // what a level plain receives, in luminance
constexpr double least_height = 0.22;    // sine of the elevation below which exposure stops rising

double luminance(const glm::dvec3& colour) {
    return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

}  // namespace

Light make_light(const SunSettings& settings) {
    const double sin_e = elementary::sin(settings.elevation * degree);
    const double cos_e = elementary::cos(settings.elevation * degree);
    const glm::dvec3 sand(0.42, 0.30, 0.18);
    const AirTables air(dusty_air(settings.dust, sand));
    constexpr double eye_height = 0.002;  // km
    const SkyView sky(air, settings.elevation * degree, eye_height);
    // White is the sum of sun and sky on level ground with the sun at 45 degrees.
    const SkyView white(air, 45.0 * degree, eye_height);
    const glm::dvec3 white_light =
        white.sun() * std::numbers::sqrt2 * 0.5 + white.level_irradiance();
    const glm::dvec3 balance = luminance(white_light) / white_light;
    const glm::dvec3 sun = sky.sun() * balance;
    const glm::dvec3 from_sky = sky.level_irradiance() * balance;
    const double received = luminance(sun) * std::max(sin_e, least_height) + luminance(from_sky);
    const double exposure = level_exposure / received;

    Light light;
    light.to_sun = {elementary::sin(settings.azimuth * degree) * cos_e,
                    elementary::cos(settings.azimuth * degree) * cos_e, sin_e};
    light.sun = glm::vec3(sun * (exposure * settings.strength));
    light.sky = glm::vec3(from_sky * (exposure * settings.sky_strength));
    light.sky_lean = glm::vec3(sky.lean());
    light.sky_columns = sky.table().columns();
    light.sky_rows = sky.table().rows();
    for (int row = 0; row < light.sky_rows; ++row) {
        for (int column = 0; column < light.sky_columns; ++column) {
            const glm::dvec3 texel =
                sky.table().at(column, row) * balance * (exposure * std::numbers::pi);
            for (int band = 0; band < 3; ++band)
                light.sky_texels.push_back(static_cast<float>(texel[band]));
        }
    }
    return light;
}

SunDirection sun_direction(const SunSettings& settings) {
    const double radius = 0.5 * settings.diameter;
    const double lower = std::clamp(settings.elevation - radius, 0.0, 89.0);
    const double upper = std::clamp(settings.elevation + radius, lower + 0.01, 89.5);
    return {static_cast<float>(elementary::sin(settings.azimuth * degree)),
            static_cast<float>(elementary::cos(settings.azimuth * degree)),
            static_cast<float>(tangent(lower)), static_cast<float>(tangent(upper))};
}

}  // namespace fumon
