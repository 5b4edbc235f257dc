#pragma once

#include <glm/glm.hpp>

#include "render/view/camera.h"
#include "render/view/lens.h"

namespace fumon {

/// Half the apparent size of the sun in the sky, radians; nearly the moon's.
inline constexpr double disc_radius = 0.004675;

/// The share of the sun's disc that an eye sees above the ground, 0 … 1, to first order in the
/// disc's size; 1 of a sun behind the camera, and without perspective, where it is not asked for.
/// `to_sun`: a unit vector, above the horizon; `curvature`: by which the ground sinks at a distance
/// of 1.
double visible_sun_share(const Camera& camera, const glm::dvec3& to_sun, const RayGround& ground,
                         double curvature);

}  // namespace fumon
