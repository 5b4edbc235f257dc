#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

/// Where a picture is taken from, in the block's lengths (see Block).
struct Camera {
    bool perspective = true;
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 forward{0, 0, -1};
    glm::dvec3 eye{0, 0, 1};
    glm::dvec2 half{1, 1};    ///< half the picture's extent: at depth 1 (perspective) or anywhere
    double focus = 1.0;       ///< depth of what it looks at, seen from a perspective eye
    double near_depth = 0.1;  ///< along `forward` from the eye; the block lies within
    double far_depth = 10.0;

    bool operator==(const Camera&) const = default;
};

/// The camera of a view, fixed by the block. `distance = fit` moves it as near as the border
/// camera.margin allows: all corners of the block, its sides included, lie inside, and it touches
/// the border on the axis that limits. Where the camera turns, one distance serves the whole turn.
/// `map` looks straight down with north up, without perspective, and one scale along both axes.
/// `progress` is the share of the run that is over, 0 … 1.
Camera place_camera(const CameraSettings& settings, const Block& block, double aspect,
                    double progress);

/// World to clip coordinates, z in −1 … 1.
glm::dmat4 clip_matrix(const Camera& camera);

/// The place in the picture of a point, −1 … 1 rightward and upward inside the frame.
glm::dvec2 project(const Camera& camera, const glm::dvec3& point);

/// The corners of the block that is framed: its outline at its base and at its top.
std::vector<glm::dvec3> block_corners(const Block& block);

/// Where the bed lies in a picture of a `map` view, in pixels from the top left corner: left, top,
/// width, height. What axes around a map need.
std::array<double, 4> map_rectangle(const View& view, const Snapshot& first);

}  // namespace fumon
