#pragma once

#include <optional>

#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/air/air_sheet.h"
#include "render/frame/tile_samples.h"
#include "render/view/block.h"
#include "render/view/camera.h"

namespace fumon {

/// A coloured point of the translucent air, in block lengths.
struct AirVertex {
    glm::vec3 point;
    glm::vec4 paint;
};

/// The paths of a section's grains as ribbons that face the camera, with grains along them: three
/// vertices to a triangle. They are spread over the strip's depth, and where a path leaves the
/// section it goes on at the other end. Hops below 1.5 % of the strip's length are left out.
std::vector<AirVertex> grain_paths(const Snapshot& strip, const Block& block, const Camera& camera);

/// The air over a strip: a translucent sheet along its far edge, and grains' paths above it.
class AirLayer {
  public:
    /// `camera` says which edge is the far one, `picture_side` how fine the sheet is painted.
    /// `mipmaps` outlives it.
    AirLayer(const Block& block, const Camera& camera, int picture_side, const gl::Constants& fixed,
             const gl::MipmapMaker& mipmaps);

    /// Takes the air of a snapshot as it is shown, which has a section.
    void set_air(const Snapshot& strip, const Block& block, const Camera& camera, WorkerPool& pool);

    /// Fills the bound target with the surroundings of the tile whose `pixels` they are; `margin`
    /// is where the tile begins in the target, samples.
    void draw_behind(const gl::Texture2D& surroundings, int factor, glm::ivec2 margin,
                     glm::ivec2 pixels) const;

    /// Blends sheet and paths over what the bound target shows.
    void draw(const Camera& camera, const TileSamples& tile) const;

  private:
    const gl::MipmapMaker& mipmaps_;
    double far_edge_;  // y of the sheet
    int texture_width_;
    Palette palette_;
    gl::Program behind_program_;
    gl::Program sheet_program_;
    gl::Program path_program_;
    gl::VertexArray sheet_array_;
    gl::VertexArray path_array_;
    gl::Buffer sheet_vertices_;
    gl::Buffer path_vertices_;
    int path_count_ = 0;
    std::optional<gl::Texture2D> texture_;
    AirSheet sheet_;
};

}  // namespace fumon
