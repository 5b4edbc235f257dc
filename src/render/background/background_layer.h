#pragma once

#include <array>
#include <optional>

#include "gl/dynamic_buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/colour/pixel_format.h"
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
    /// `wanted`: of the picture, which may be drawn from others.
    BackgroundLayer(const View& view, const Block& block, const Light& light, const FloorMap& floor,
                    const gl::Constants& fixed, PixelFormat wanted);

    /// For the light of another sun.
    void set_floor(const FloorMap& floor) const;

    /// Draws the clouds that a tile sees, where there are any, into a target of its own, for
    /// draw().
    void draw_clouds(const Light& light, const Camera& camera, const Tile& tile);

    /// The share of the sun's light that clouds before its disc let through to the camera.
    [[nodiscard]] float sun_through_clouds(const Light& light, const Camera& camera);

    /// Draws one tile's background into the bound target. Stencils and depths may keep it
    /// out. `first_drawn`: within the tile, from below, the corner of that which layers drew.
    void draw(const Light& light, const Camera& camera, const Tile& tile, RowOrder order,
              const glm::ivec2& first_drawn = {0, 0});
    /// The same, from the lowest row on, of some parts of the tile (rows from above) alone.
    void draw(const Light& light, const Camera& camera, const Tile& tile,
              const std::vector<Tile>& parts);

  private:
    const gl::Program& program(bool plain_alone, bool stars, bool in_parts);
    bool start(const Light& light, const Camera& camera, const Tile& tile, RowOrder order,
               const glm::ivec2& first_drawn, bool in_parts);
    void start_clouds(const Light& light, const Camera& camera, const Tile& tile);
    void set_rays(const gl::Program& program, const Light& light, const Camera& camera) const;

    View view_;
    Block block_;
    gl::Constants fixed_;
    PixelFormat wanted_;
    std::array<std::optional<gl::Program>, 8> programs_;  // made as they are needed
    float clouds_;                                        // of the programs
    std::optional<gl::Program> cloud_program_;
    std::optional<gl::RenderTarget> cloud_target_;
    gl::Texture2D floor_;
    gl::VertexArray parts_array_;
    gl::DynamicBuffer parts_corners_{GL_ARRAY_BUFFER};
};

}  // namespace fumon
