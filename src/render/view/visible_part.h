#pragma once

#include <glm/glm.hpp>

#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// The part of a block's ground that a picture may show.
struct VisiblePart {
    glm::dvec2 low{0.0};   ///< its south-western corner, 0 … 1 over the block
    glm::dvec2 high{1.0};  ///< its north-eastern one; not above `low` where nothing is seen
    double sharpness = 0;  ///< pixels to a block length at the nearer ground: a quarter is nearer
};

/// No point outside the part is seen, whatever the ground between the block's base and its top; a
/// lens, whose points see past the picture's border, is taken to show all.
VisiblePart visible_part(const Camera& camera, const View& view, const Block& block);

}  // namespace fumon
