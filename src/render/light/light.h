#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/light/sun_sweep.h"
#include "scene/scene.h"

namespace fumon {

/// Colours and strengths of the light, linear RGB, exposure already in them.
struct Light {
    glm::vec3 to_sun{0, 0, 1};  ///< unit vector
    glm::vec3 sun{1};           ///< irradiance on a surface that faces the sun
    glm::vec3 sky{1};           ///< irradiance of the whole sky on level ground
    glm::vec3 sky_lean{0.25F};  ///< of it, how much more a slope of 1 toward the sun gets
    /// The sky's radiances times π, a texel each: azimuth from the sun along the columns (0 … π),
    /// the square root of the elevation along the rows (0 … √(π/2)); RGB.
    std::vector<float> sky_texels;
    int sky_columns = 0;
    int sky_rows = 0;
};

/// The light of a clear day from the tables of render/sky. The exposure follows a level sand plain,
/// so that a low sun gives a warm picture, not a black one.
Light make_light(const SunSettings& settings);

/// The sun's place and disc for a sweep.
SunDirection sun_direction(const SunSettings& settings);

}  // namespace fumon
