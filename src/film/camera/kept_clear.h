#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "film/camera/stage.h"

namespace fumon {

/// Whether the convex hull of some points has a place in common with a box.
bool hull_meets_box(const std::vector<glm::dvec2>& points, const PictureBox& box);

/// From what a camera looks at, block lengths: from `distance` on as near as the stage's block is
/// seen clear of the boxes that it is to leave free. `distance` itself where half as far again is
/// not enough.
double clear_distance(const FilmStage& stage, const glm::dvec3& subject, double azimuth,
                      double elevation, double focal_length, double distance);

}  // namespace fumon
