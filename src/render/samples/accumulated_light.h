#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// The light of a tile's pixels, a mean over some pictures of it that are seen through the points
/// of a lens. Sums run in the order of these.
class AccumulatedLight {
  public:
    explicit AccumulatedLight(const Tile& tile);

    /// Adds the bound target of radiances, whose first pixel of this tile is `from`; what is not
    /// covered has the opacity 0.
    void add(const glm::ivec2& from, WorkerPool& pool);
    /// Divides by their number. What add() has added is light times opacity.
    void finish(WorkerPool& pool);

    /// RGBA, rows from the upper one on.
    [[nodiscard]] const float* row(int y) const {
        return light_.data() +
               4 * static_cast<std::size_t>(tile_.width) * static_cast<std::size_t>(y);
    }
    [[nodiscard]] const Tile& tile() const { return tile_; }

  private:
    Tile tile_;
    int added_ = 0;
    std::vector<float> light_;
    std::vector<float> read_;  // a few rows
};

}  // namespace fumon
