#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

/// What a camera sees through, in the block's lengths: a thin lens around the eye, before a picture
/// that stays where it is. A point at depth z is spread over a disc of 2·radius·|1/z − 1/focus| at
/// depth 1, the circle of confusion.
struct Lens {
    double radius = 0.0;  ///< 0: a pinhole
    double focus = 1.0;   ///< the depth at which all is sharp
    // Of one of the many pictures whose mean a lens makes:
    glm::dvec2 point{0.0};  ///< which it is seen through, rightward and upward from the eye
    glm::dvec2 aside{0.0};  ///< by how much it is moved, of half the picture's extent

    bool operator==(const Lens&) const = default;
};

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
    double focal_length = 50.0;  ///< mm, of a lens before 36 × 24 mm (perspective)
    Lens lens{};                 ///< (perspective)

    /// The direction in which the picture's middle sees, through the lens's point.
    [[nodiscard]] glm::dvec3 ahead() const {
        if (lens.radius == 0.0) return forward;
        const glm::dvec2 to = lens.point / lens.focus + lens.aside * half;
        return forward - to.x * right - to.y * up;
    }
    /// And from where.
    [[nodiscard]] glm::dvec3 seen_from() const {
        return lens.radius == 0.0 ? eye : eye + lens.point.x * right + lens.point.y * up;
    }

    bool operator==(const Camera&) const = default;
};

/// The camera of a view, fixed by the block. `distance = fit` moves it as near as the border
/// camera.margin allows: all corners of the block, its sides included, lie inside, and it touches
/// the border on the axis that limits. `auto` is `fit`, but where the block goes on beyond its
/// edges its nearest point lies at the picture's lower edge, or the block's middle is as broad as
/// the picture, whichever is nearer; not where the camera turns or looks down steeply. Where it
/// turns, one distance serves the whole turn.
/// `map` looks straight down with north up, without perspective, and one scale along both axes.
/// `progress` is the share of the run that is over, 0 … 1.
Camera place_camera(const CameraSettings& settings, const Block& block, double aspect,
                    double progress);

/// World to clip coordinates, z in −1 … 1; through the lens's point.
glm::dmat4 clip_matrix(const Camera& camera);

/// The place in the picture of a point, −1 … 1 rightward and upward inside the frame; of a pinhole.
glm::dvec2 project(const Camera& camera, const glm::dvec3& point);

/// The corners of the block that is framed: its outline at its base and at its top.
std::vector<glm::dvec3> block_corners(const Block& block);

/// Where the bed lies in a picture of a `map` view, in pixels from the top left corner: left, top,
/// width, height. What axes around a map need.
std::array<double, 4> map_rectangle(const View& view, const Snapshot& first);

}  // namespace fumon
