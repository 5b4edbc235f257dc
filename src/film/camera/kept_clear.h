#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "film/camera/stage.h"

namespace fumon {

/// Whether the convex hull of some points has a place in common with a box.
bool hull_meets_box(const std::vector<glm::dvec2>& points, const PictureBox& box);

/// Poses from which the stage's block is seen clear of the boxes that it is to leave free: all as
/// much farther from what they look at as one another, and all with it as far beside the picture's
/// middle, as near and as little beside as may be. Boxes of captions are left free where that is
/// possible. The poses themselves where twice as far is not enough.
std::vector<CameraPose> clear_poses(const FilmStage& stage, std::vector<CameraPose> poses);

/// Whether the stage's block, seen from a pose, meets a box that it is to leave free.
bool is_covered(const FilmStage& stage, const CameraPose& pose);

}  // namespace fumon
