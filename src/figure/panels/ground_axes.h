#pragma once

#include <glm/glm.hpp>

#include "figure/canvas/canvas.h"
#include "render/view/camera.h"

namespace fumon {

/// How the two directions of level ground lie on a canvas (x rightward, y downward).
struct GroundAxes {
    glm::dvec2 east{1.0, 0.0};
    glm::dvec2 north{0.0, -1.0};

    /// What a vector of the ground (east, north) becomes.
    [[nodiscard]] glm::dvec2 operator()(const glm::dvec2& ground) const {
        return ground.x * east + ground.y * north;
    }
};

/// Those of a map: east to the right, north up.
inline GroundAxes map_axes() {
    return {};
}

/// How a camera's picture of a block lies in a box of a canvas: the whole picture fills `picture`,
/// which may reach beyond what is shown of it.
struct ViewProjection {
    Camera camera;
    Block block;
    CanvasBox picture;

    /// Where a point of the block (its lengths, see Block) is seen.
    [[nodiscard]] CanvasPoint at(const glm::dvec3& point) const;
    /// Where a place of the ground is seen: metres or sites from the bed's south-west corner, z in
    /// the block's lengths.
    [[nodiscard]] CanvasPoint at_ground(const glm::dvec2& place, double z) const;
};

/// The directions of level ground as that view shows them at the block's middle, shortened as seen,
/// scaled so that the direction that is seen longest has the length 1.
GroundAxes visible_axes(const ViewProjection& view);

}  // namespace fumon
