#pragma once

#include <glm/glm.hpp>

#include "render/view/tile_warp.h"

/// See vectors/target.h: the same bits on every target.
namespace fumon::tile_warp {

/// Of a point, periods from the middle of what is as it is; `strength`: 0 … 1.
WarpedGround warp_at(const glm::dvec2& periods, double strength);

}  // namespace fumon::tile_warp
