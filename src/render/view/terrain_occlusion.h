#pragma once

#include <glm/glm.hpp>

#include "base/snapshot.h"
#include "render/view/block.h"
#include "render/view/camera.h"

namespace fumon {

/// The ground of a picture, as far as it hides what lies behind it. Of a snapshot as it is shown,
/// its block and the camera, which outlive it.
class TerrainOcclusion {
  public:
    TerrainOcclusion(const Snapshot& snapshot, const Block& block, const Camera& camera);

    /// Of a point in cells, the middle of the first being (0, 0): the point of the ground, in the
    /// block's lengths.
    [[nodiscard]] glm::dvec3 point(const glm::dvec2& cell) const;

    /// Whether the camera sees a point of the ground: whether nothing on the way, half a cell at a
    /// time, rises above it.
    [[nodiscard]] bool visible(const glm::dvec2& cell) const;

  private:
    [[nodiscard]] bool inside(const glm::dvec2& cell) const;
    [[nodiscard]] double z(const glm::dvec2& cell) const;

    const Snapshot& snapshot_;
    const Block& block_;
    const Camera& camera_;
    glm::dvec2 cells_;  ///< in a block length
    double highest_ = 0.0;
};

}  // namespace fumon
