#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace fumon {

/// Diffuse reflectances of sand, linear sRGB.
struct SandColours {
    glm::vec3 crest;   ///< high and open to the sky
    glm::vec3 trough;  ///< low
};

/// Of look.sand; quartz on a block is more saturated than on endless ground, whose light does more.
SandColours sand_colours(const LookSettings& look);

}  // namespace fumon
