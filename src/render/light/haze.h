#pragma once

#include <glm/glm.hpp>

#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

/// What the lowest air takes out of light, where haze follows distance.
struct Haze {
    double per_kilometre = 0.0;  ///< extinction of green light near the ground
    glm::dvec3 bands{1.0};       ///< that of red, green and blue light (linear sRGB) against it
    double height = 1.6;         ///< km over which it thins by e, as clouds are seen through it
};

/// Of a view whose ground is chosen: as far as air.visibility says, or as its air lets one see.
Haze haze_of(const View& view, const Block& block);

/// Extinction of green light along the way from an eye in block lengths to the ground, per block
/// length.
double extinction_from(const glm::dvec3& eye, const Haze& haze, const View& view,
                       const Block& block);

}  // namespace fumon
