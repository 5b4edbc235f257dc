#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/view/camera.h"

namespace fumon {

/// Of a picture of so many rows those, from the lowest on, above which no ground is seen.
/// `skyline`: see GroundMesh. All of them where the picture does not show that: of a camera that
/// looks down on itself or lies on its side, or without perspective.
int rows_below_skyline(const std::vector<glm::vec3>& skyline, const Camera& camera, int rows);

}  // namespace fumon
