#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/light/floor_map.h"
#include "render/light/light.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// Which row of a tile a target holds first.
enum class RowOrder { downward, upward };

/// Draws what surrounds the block: plain and sky, or white paper in figure mode.
class BackgroundLayer {
  public:
    BackgroundLayer(const View& view, const Block& block, const FloorMap& floor,
                    const gl::Constants& fixed);

    /// For the light of another sun.
    void set_floor(const FloorMap& floor) const;

    /// Draws one tile's background into the bound target. Stencils may keep it out.
    void draw(const Light& light, const Camera& camera, const Tile& tile, RowOrder order) const;

  private:
    View view_;
    Block block_;
    gl::Program program_;
    gl::Texture2D floor_;
};

}  // namespace fumon
