#pragma once

#include <glm/glm.hpp>

#include "render/frame/tile_samples.h"
#include "render/light/light.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// A tile while its passes run: where it lies in the picture, and from where and in which light it
/// is seen.
struct TileFrame {
    const View& view;
    const TilePlan& plan;
    const Tile& tile;
    const Camera& camera;
    const Light& light;
    WorkerPool& pool;

    /// Pixels of the whole picture.
    [[nodiscard]] glm::ivec2 picture() const;
    /// Rows of pixels below the tile.
    [[nodiscard]] int rows_below() const;
    /// The tile's first sample, and the sample that its targets of samples begin at; from the
    /// picture's lower left.
    [[nodiscard]] glm::ivec2 first_sample() const;
    [[nodiscard]] glm::ivec2 target_corner() const;
    /// Where the tile's first sample lies in its targets of samples.
    [[nodiscard]] glm::ivec2 first_in_target() const { return first_sample() - target_corner(); }
    /// Where targets of samples lie in the picture.
    [[nodiscard]] TileSamples samples() const;
    /// The same, in pixels, of a target of pixels of that size.
    [[nodiscard]] TileSamples pixels(const glm::ivec2& target_size) const;
};

}  // namespace fumon
