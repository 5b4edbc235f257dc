#pragma once

#include "figure/canvas/canvas.h"

namespace fumon {

/// What sand, water and the lines on them are drawn with in cuts through the ground.
constexpr Ink ground_ink{0.80, 0.74, 0.64, 1.0};
constexpr Ink water_ink{0.56, 0.74, 0.88, 1.0};
/// Under lines and arrows on a picture.
constexpr Ink halo{1.0, 1.0, 1.0, 0.55};
constexpr Ink dark_ink{0.05, 0.05, 0.05, 1.0};

}  // namespace fumon
