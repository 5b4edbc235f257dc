#pragma once

#include <glm/glm.hpp>

#include "render/view/far_copies.h"

/// See vectors/target.h: the same bits on every target.
namespace fumon::far_copies {

/// Of a place, periods from the middle of what is as it is; `strength`: 0 … 1.
GroundCopy copy_at(const glm::dvec2& periods, double strength);

}  // namespace fumon::far_copies
