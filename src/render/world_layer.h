#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed_shading.h"
#include "render/light/light.h"
#include "render/terrain_layer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/display_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A periodic bed repeated to the horizon: a fan of rays and rings around the camera, raised by the
/// bed's heights.
class WorldLayer {
  public:
    WorldLayer(const View& view, const Block& block, const DisplayBed& first_bed);

    /// Heights as z of the block.
    void set_bed(const Field<float>& z);

    /// Draws into the bound target.
    void draw(const BedShading& shading, const Light& light, const Camera& camera,
              const TileSamples& tile) const;

  private:
    void build();

    View view_;
    Block block_;
    float cell_;
    gl::Program program_;
    gl::Texture2D heights_;
    gl::VertexArray array_;
    gl::Buffer places_;
    gl::Buffer triangles_;
    GLsizei indices_ = 0;
    int rays_ = 0;
    int rings_ = 0;
};

}  // namespace fumon
