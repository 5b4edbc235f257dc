#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "render/light/sun_sweep.h"
#include "scene/scene.h"

namespace fumon {

/// Colours and strengths of the light, linear RGB, exposure already in them.
struct Light {
    glm::vec3 to_sun{0, 0, 1};  ///< unit vector
    glm::vec3 sun{1};           ///< irradiance on a surface that faces the sun
    float visible_sun = 1.0F;   ///< share of its light that reaches the eye, for glare
    glm::vec3 sky{1};           ///< irradiance of the whole sky on level ground
    glm::vec3 haze{1};          ///< what far things fade into, away from the sun
    glm::vec3 glow{1};          ///< the same towards the sun
    glm::vec3 zenith{1};        ///< the sky overhead
    glm::vec3 sun_aloft{1};     ///< of the sun at the clouds' height, as `sun`
    glm::vec2 cloud_shift{0};   ///< how far clouds have drifted, km east and north
    double stops = 0.0;         ///< of exposure, besides look.exposure
    double metered = 1.0;       ///< the share of that exposure which a bright sky leaves
    float in_air = 1.0F;        ///< what things in the air get of `sun` and `sky`; 1 on the ground
    bool stars = false;
    bool studio = false;      ///< of a lamp: around the block are table and wall, not land and sky
    bool atmosphere = false;  ///< the sky is that of the texels, not of the three colours
    /// How much more of the sky's light than of a uniform sky's a slope gets: with a normal whose
    /// part along the sun's azimuth is x and upward 1 − t, its products with x, x², t and t·x.
    std::array<glm::vec3, 4> sky_lean{};
    /// Radiances of the sky times π, RGB and a fourth number without meaning, since llvmpipe reads
    /// texels of four faster: the square root of the azimuth from the sun along the columns (0 …
    /// √π), that of the elevation along the rows (0 … √(π/2)).
    std::vector<glm::vec4> sky_texels = std::vector<glm::vec4>(1);
    int sky_columns = 1;
    int sky_rows = 1;
};

/// Irradiance of level ground on a clear day with the sun at 45°, at 680, 550 and 440 nm, against
/// that of the sun above the air: what is white. By the tables of render/sky, of thin air with dust
/// 1 and 2 m above the ground; a constant, since these tables take a tenth of a second.
inline constexpr glm::dvec3 clear_day{0.68625908130460811, 0.64505341022073548,
                                      0.60816770718851454};

/// The light of a clear day: the lower the sun, the longer its way through the air, the warmer and
/// weaker its light (extinction in three bands along the optical air mass, Kasten & Young 1989).
/// The exposure follows a level sand plain, so that a low sun gives a warm picture, not a black
/// one.
Light make_light(const SunSettings& settings);

/// The same by the tables of render/sky, the air and the sun's strength at the ground included.
/// White is the light of a clear day on Earth with the sun at 45°. Moonlight is drawn as eyes see
/// it: two stops darker than a meter would have it, with little colour and bluish, the sky darker
/// still (Jensen et al. 2000, "Night rendering"). `cloud_height`: km, of Light::sun_aloft.
Light make_atmospheric_light(const SunSettings& settings, Planet planet = Planet::earth,
                             double cloud_height = 0.0, Aerosol aerosol = Aerosol::thin);

/// The light of an even cover of clouds: white, a little of it from where the sun stands; overhead
/// the sky is three times as bright as at the horizon (Moon & Spencer 1942, the CIE's overcast
/// sky).
Light make_overcast_light(const SunSettings& settings);

/// The light of a studio: a lamp in the sun's place, `studio_lamp_width` wide, which gives the
/// table more than half of its light, and even light from all around; both without colour to the
/// eye. Haze and zenith are those of a wall that the table passes into. settings.strength and
/// sky_strength are factors of both.
Light make_studio_light(const SunSettings& settings);
inline constexpr double studio_lamp_width = 30.0;  ///< degrees

/// To the sun, a unit vector: x east, y north, z up.
glm::vec3 direction_to(const SunSettings& sun);

/// The sun's place and disc for a sweep.
SunDirection sun_direction(const SunSettings& settings);

}  // namespace fumon
