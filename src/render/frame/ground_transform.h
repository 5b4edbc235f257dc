#pragma once

#include <glm/glm.hpp>

#include "render/view/tile_warp.h"

namespace fumon {

/// How the ground is rasterised, for what stands on it.
struct GroundTransform {
    glm::mat4 clip{1.0F};    ///< world to clip coordinates, or of offsets from the eye
    bool endless = false;    ///< repeated to the horizon, drawn by offsets from the eye
    float curvature = 0.0F;  ///< see WorldLayer::curvature()
    glm::dvec2 origin{0.0};  ///< where the drawn bed begins, see DrawnOrigin
    TileWarp copies{};
    glm::dvec2 eye_from_middle{0.0};  ///< see WorldLayer
};

}  // namespace fumon
