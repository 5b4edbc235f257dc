#pragma once

#include <glm/glm.hpp>

#include "gl/program.h"
#include "render/light/light.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// 0 where no clouds are drawn: figures, and skies that are not the scattered one.
float cloud_number(const View& view, const Light& light);

/// How far clouds have drifted at a share of a run, km east and north.
glm::vec2 cloud_shift(const AirSettings& air, double share_of_run);

/// The uniforms of sky/cloud_shapes.glsl, where clouds are drawn.
void set_clouds(const gl::Program& program, const View& view, const Light& light,
                const Camera& camera, const Block& block);

}  // namespace fumon
