#include "render/light/light.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/units.h"
#include "render/sky/desert_aerosol.h"
#include "render/sky/sky_tables.h"

namespace fumon {

namespace {

// Extinction of red, green and blue light per unit of air mass: Rayleigh scattering and desert
// dust.
constexpr glm::dvec3 extinction{0.09, 0.145, 0.25};
constexpr glm::dvec3 sky_colour{0.56, 0.74, 1.0};
constexpr double sky_share = 0.26;       // sky light against sun light on a plain, sun at 45°
constexpr double level_exposure = 0.80;  // what a level plain receives, in luminance
constexpr double photographic_exposure = 1.25;  // the same under the scattered sky
constexpr double least_height = 0.22;  // sine of the elevation below which exposure stops rising
constexpr double thin_aerosol = 3.0;   // of a clear day, times that of Hillaire (2020)
constexpr double aureole = 30.0 * degree;  // about what hides the sun hides around it too
constexpr double adaptation = 0.2;         // to the colour of the present light
// Sand on endless ground is drawn with a reflectance of 0.46 (render/colour/sand_colours.h) and
// exposed as such. That of dunes is 0.35 (Libya 4, by which satellites are calibrated), against
// which the sky is as much brighter.
constexpr double sky_over_drawn_ground = 0.46 / 0.35;

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

/// Linear sRGB of light as a share of sunlight at 680, 550 and 440 nm, in between quadratic in the
/// wavelength: the colour-matching functions of the CIE (1931, as fitted by Wyman, Sloan & Shirley
/// 2013) over a black body of 5778 K, so that sunlight is white.
glm::dvec3 srgb_of_wavelengths(const glm::dvec3& light) {
    const glm::dvec3 red(0.4849, 0.7277, -0.2126);
    const glm::dvec3 green(-0.0325, 1.0179, 0.0146);
    const glm::dvec3 blue(-0.0383, 0.0672, 0.9711);
    const glm::dvec3 found(glm::dot(red, light), glm::dot(green, light), glm::dot(blue, light));
    return glm::max(found, glm::dvec3(0.0));
}

/// The tables of a planet's air with so much dust. The last ones are kept: they are the same
/// wherever the sun stands, and take longer than all else that a moved sun asks for.
std::shared_ptr<const AirTables> tables_of_air(Planet planet, double dust, Aerosol aerosol) {
    const glm::dvec3 sand(0.42, 0.30, 0.18);
    const glm::dvec3 martian(0.30, 0.15, 0.07);
    struct Kept {
        Planet planet;
        double dust;
        Aerosol aerosol;
        std::shared_ptr<const AirTables> tables;
    };
    static std::mutex alone;
    static std::optional<Kept> last;
    const std::lock_guard lock(alone);
    if (!last || last->planet != planet || last->dust != dust || last->aerosol != aerosol) {
        const Atmosphere air = planet == Planet::mars       ? martian_air(dust, martian)
                               : aerosol == Aerosol::desert ? desert_air(dust, sand)
                                                            : dusty_air(dust, sand);
        last = Kept{planet, dust, aerosol, std::make_shared<const AirTables>(air)};
    }
    return last->tables;
}

/// Light::sky_lean, by least squares over slopes of up to 45 degrees.
std::array<glm::vec3, 4> fitted_lean(const SkyView& view) {
    glm::dmat4 products(0.0);
    std::array<glm::dvec4, 3> sums{glm::dvec4(0.0), glm::dvec4(0.0), glm::dvec4(0.0)};
    const glm::dvec3 level =
        glm::max(srgb_of_wavelengths(view.level_irradiance()), glm::dvec3(1e-9));
    for (const double tilt : {15.0, 30.0, 45.0}) {
        const double up = elementary::cos(tilt * degree);
        for (int azimuth = 0; azimuth <= 180; azimuth += 30) {
            const double x = elementary::sin(tilt * degree) * elementary::cos(azimuth * degree);
            const glm::dvec3 share = srgb_of_wavelengths(view.irradiance(x, up)) / level;
            const glm::dvec4 terms(x, x * x, 1.0 - up, (1.0 - up) * x);
            products += glm::outerProduct(terms, terms);
            for (int band = 0; band < 3; ++band)
                sums[static_cast<std::size_t>(band)] +=
                    terms * (share[band] / (0.5 + 0.5 * up) - 1.0);
        }
    }
    const glm::dmat4 inverse = glm::inverse(products);
    std::array<glm::vec3, 4> lean{};
    for (int band = 0; band < 3; ++band) {
        const glm::dvec4 factors = inverse * sums[static_cast<std::size_t>(band)];
        for (int term = 0; term < 4; ++term)
            lean[static_cast<std::size_t>(term)][band] = static_cast<float>(factors[term]);
    }
    return lean;
}

/// What colours are multiplied by: white lies between a clear day's light and what level ground
/// gets now, since eyes and cameras adapt in part.
glm::dvec3 adapted_white(const glm::dvec3& day, const glm::dvec3& now, bool desert) {
    glm::dvec3 white(1.0);
    // As films do, a little away from green, which skies and sand under them are not to look; the
    // horizon of a desert is then mauve before long.
    const glm::dvec3 film = desert ? glm::dvec3(1.0, 0.985, 1.01) : glm::dvec3(1.0, 0.975, 1.015);
    for (int band = 0; band < 3; ++band) {
        white[band] = film[band] * elementary::pow(luminance(day) / day[band], 1.0 - adaptation) *
                      elementary::pow(luminance(now) / now[band], adaptation);
    }
    return white;
}

/// Of sunlight: what rods see of the moon's.
glm::vec3 by_night(const glm::vec3& light) {
    constexpr float share = 0.25F;     // of the exposure by day
    constexpr float colourful = 0.1F;  // cones still see a little
    const glm::vec3 rods(0.44F, 0.86F, 2.15F);
    const auto bright = static_cast<float>(luminance(glm::dvec3(light)));
    return share * glm::mix(bright * rods, light, colourful);
}

void turn_to_night(Light& light) {
    constexpr float visible_sky_share = 0.2F;  // it looks black beside lit ground
    light.stars = true;
    light.sun = by_night(light.sun);
    light.sun_aloft = by_night(light.sun_aloft);
    light.sky = by_night(light.sky);
    for (glm::vec4& texel : light.sky_texels)
        texel = glm::vec4(visible_sky_share * by_night(glm::vec3(texel)), 0.0F);
}

}  // namespace

glm::vec3 direction_to(const SunSettings& sun) {
    const double level = elementary::cos(sun.elevation * degree);
    return {elementary::sin(sun.azimuth * degree) * level,
            elementary::cos(sun.azimuth * degree) * level, elementary::sin(sun.elevation * degree)};
}

Light make_light(const SunSettings& settings) {
    const double sin_e = elementary::sin(settings.elevation * degree);
    const glm::dvec3 sun =
        transmittance(air_mass(settings.elevation)) / luminance(transmittance(air_mass(45.0)));
    const double sky_level = sky_share * (0.35 + 0.65 * std::sqrt(sin_e));
    const glm::dvec3 sky = sky_colour * (sky_level / luminance(sky_colour));
    const double received = luminance(sun) * std::max(sin_e, least_height) + luminance(sky);
    const double exposure = level_exposure / received;

    Light light;
    light.to_sun = direction_to(settings);
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

Light make_atmospheric_light(const SunSettings& settings, Planet planet, double cloud_height,
                             Aerosol aerosol) {
    constexpr double eye_height = 0.002;  // km
    const double sin_e = elementary::sin(settings.elevation * degree);
    const glm::dvec3 day = srgb_of_wavelengths(clear_day);
    const bool desert = planet == Planet::earth && aerosol == Aerosol::desert;
    const double dust =
        planet == Planet::earth && !desert ? thin_aerosol * settings.dust : settings.dust;
    const std::shared_ptr<const AirTables> air = tables_of_air(planet, dust, aerosol);
    const SkyView view(*air, settings.elevation * degree, eye_height, desert ? aureole : 0.0);
    const glm::dvec3 level = srgb_of_wavelengths(view.level_irradiance());
    const glm::dvec3 direct = srgb_of_wavelengths(view.sun() + view.aureole());
    const glm::dvec3 now = direct * sin_e + level;
    const glm::dvec3 white = adapted_white(day, now, desert);
    const glm::dvec3 sun = direct * white;
    const glm::dvec3 sky = level * white;
    const double received = luminance(sun) * std::max(sin_e, least_height) + luminance(sky);
    const double exposure = photographic_exposure / received;

    Light light;
    light.atmosphere = true;
    light.to_sun = direction_to(settings);
    const bool by_day = settings.source != LightSource::moon;
    const double above_ground = desert && by_day ? sky_over_drawn_ground : 1.0;
    const double seen = exposure * above_ground;
    light.in_air = static_cast<float>(above_ground);
    light.sun = glm::vec3(sun * (exposure * settings.strength));
    light.sky = glm::vec3(sky * (exposure * settings.sky_strength));
    const glm::dvec3 aloft = air->transmittance(air->air().ground + cloud_height, sin_e);
    light.sun_aloft = glm::vec3(srgb_of_wavelengths(aloft) * white * (seen * settings.strength));
    light.sky_lean = fitted_lean(view);
    light.sky_columns = view.table().columns();
    light.sky_rows = view.table().rows();
    light.sky_texels.clear();
    for (int row = 0; row < light.sky_rows; ++row) {
        for (int column = 0; column < light.sky_columns; ++column) {
            const glm::dvec3 texel = srgb_of_wavelengths(view.table().at(column, row)) * white *
                                     (seen * settings.sky_strength * std::numbers::pi);
            light.sky_texels.emplace_back(glm::vec3(texel), 0.0F);
        }
    }
    if (settings.source == LightSource::moon) turn_to_night(light);
    return light;
}

Light make_overcast_light(const SunSettings& settings) {
    constexpr double sun_share = 0.10;
    const glm::dvec3 cloud(0.965, 1.0, 1.035);
    const double zenith = 9.0 / 7.0 * level_exposure;  // times pi, of such a sky
    Light light;
    light.to_sun = direction_to(settings);
    light.sun = glm::vec3(cloud * (sun_share * level_exposure * settings.strength));
    light.sky = glm::vec3(cloud * (level_exposure * settings.sky_strength));
    light.zenith = glm::vec3(cloud * (zenith * settings.sky_strength));
    light.haze = light.zenith * (1.0F / 3.0F);
    light.glow = light.haze * 1.1F;
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
