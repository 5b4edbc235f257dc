#include "render/light/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/units.h"
#include "render/sky/sky_tables.h"

namespace fumon {

namespace {

// Extinction of red, green and blue light per unit of air mass: Rayleigh scattering and desert
// dust.
constexpr glm::dvec3 extinction{0.09, 0.145, 0.25};
constexpr glm::dvec3 sky_colour{0.56, 0.74, 1.0};
constexpr double sky_share = 0.26;       // sky light against sun light on a plain, sun at 45°
constexpr double level_exposure = 0.80;  // what a level plain receives, in luminance
constexpr double least_height = 0.22;    // sine of the elevation below which exposure stops rising

double luminance(const glm::dvec3& colour) {
    return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double air_mass(double elevation) {
    const double e = std::max(elevation, 0.0);
    return 1.0 / (elementary::sin(e * degree) + 0.50572 * elementary::pow(e + 6.07995, -1.6364));
}

glm::dvec3 transmittance(double mass) {
    return {elementary::exp(-extinction.r * mass), elementary::exp(-extinction.g * mass),
            elementary::exp(-extinction.b * mass)};
}

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

}  // namespace

Light make_light(const SunSettings& settings) {
    const double sin_e = elementary::sin(settings.elevation * degree);
    const double cos_e = elementary::cos(settings.elevation * degree);
    const glm::dvec3 sun =
        transmittance(air_mass(settings.elevation)) / luminance(transmittance(air_mass(45.0)));
    const double sky_level = sky_share * (0.35 + 0.65 * std::sqrt(sin_e));
    const glm::dvec3 sky = sky_colour * (sky_level / luminance(sky_colour));
    const double received = luminance(sun) * std::max(sin_e, least_height) + luminance(sky);
    const double exposure = level_exposure / received;

    Light light;
    light.to_sun = {elementary::sin(settings.azimuth * degree) * cos_e,
                    elementary::cos(settings.azimuth * degree) * cos_e, sin_e};
    light.sun = glm::vec3(sun * (exposure * settings.strength));
    light.sky = glm::vec3(sky * (exposure * settings.sky_strength));
    // Haze scatters both: its colour lies between the sky's and the sun's.
    const glm::dvec3 sun_tint = sun / luminance(sun);
    const glm::dvec3 sky_tint = sky_colour / luminance(sky_colour);
    light.haze = glm::vec3(0.80 * glm::mix(sun_tint, sky_tint, 0.55));
    light.glow = glm::vec3(0.90 * glm::mix(sun_tint, sky_tint, 0.08));
    light.zenith = glm::vec3(0.16, 0.30, 0.58);
    return light;
}

Light make_atmospheric_light(const SunSettings& settings) {
    const glm::dvec3 sand(0.42, 0.30, 0.18);
    constexpr double eye_height = 0.002;  // km
    constexpr double usual_elevation = 45.0;
    const double sin_e = elementary::sin(settings.elevation * degree);
    const double cos_e = elementary::cos(settings.elevation * degree);
    const AirTables clear(dusty_air(1.0, sand));
    const SkyView usual(clear, usual_elevation * degree, eye_height);
    const glm::dvec3 day =
        usual.sun() * elementary::sin(usual_elevation * degree) + usual.level_irradiance();
    const glm::dvec3 white = luminance(day) / day;
    const AirTables air(dusty_air(settings.dust, sand));
    const SkyView view(air, settings.elevation * degree, eye_height);
    const glm::dvec3 sun = view.sun() * white;
    const glm::dvec3 sky = view.level_irradiance() * white;
    const double received = luminance(sun) * std::max(sin_e, least_height) + luminance(sky);
    const double exposure = level_exposure / received;

    Light light;
    light.atmosphere = true;
    light.to_sun = {elementary::sin(settings.azimuth * degree) * cos_e,
                    elementary::cos(settings.azimuth * degree) * cos_e, sin_e};
    light.sun = glm::vec3(sun * (exposure * settings.strength));
    light.sky = glm::vec3(sky * (exposure * settings.sky_strength));
    light.sky_lean = glm::vec3(view.lean());
    light.sky_columns = view.table().columns();
    light.sky_rows = view.table().rows();
    light.sky_texels.clear();
    for (int row = 0; row < light.sky_rows; ++row) {
        for (int column = 0; column < light.sky_columns; ++column) {
            const glm::dvec3 texel = view.table().at(column, row) * white *
                                     (exposure * settings.sky_strength * std::numbers::pi);
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
