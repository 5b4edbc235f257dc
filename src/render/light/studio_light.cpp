#include <algorithm>

#include "base/elementary.h"
#include "base/units.h"
#include "render/light/light.h"

namespace fumon {

namespace {

constexpr double level_light = 0.86;  // what the table receives, in luminance
constexpr double lamp_share = 0.58;   // of it, by the lamp
constexpr double least_lamp_height =
    0.3;  // sine of the lamp's elevation below which it is no brighter
constexpr glm::dvec3 lamp_colour{1.012, 0.998, 0.982};
constexpr glm::dvec3 fill_colour{0.988, 1.001, 1.022};
constexpr float wall_low = 0.58F;   // radiances times pi: where the table passes into the wall …
constexpr float wall_high = 0.26F;  // … and overhead

}  // namespace

Light make_studio_light(const SunSettings& settings) {
    const double height = elementary::sin(settings.elevation * degree);
    Light light;
    light.studio = true;
    light.to_sun = direction_to(settings);
    light.sun = glm::vec3(lamp_colour * (lamp_share * level_light /
                                         std::max(height, least_lamp_height) * settings.strength));
    light.sky = glm::vec3(fill_colour * ((1.0 - lamp_share) * level_light * settings.sky_strength));
    light.haze = glm::vec3(wall_low);
    light.glow = light.haze;
    light.zenith = glm::vec3(wall_high);
    return light;
}

}  // namespace fumon
