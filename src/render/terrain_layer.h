#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/light/light.h"
#include "render/terrain_mesh.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// Where a tile lies in the picture, in samples from the lower left corner.
struct TileSamples {
    glm::vec2 picture_size;
    glm::vec2 corner;
    glm::vec2 size;
};

/// The block: the bed's surface, coloured by a shaded texture, and its sides.
class TerrainLayer {
  public:
    TerrainLayer(const View& view, const Block& block);

    /// Takes the heights of a snapshot and meshes the bed anew if its stride or domain has changed.
    /// `water_depth`, in block lengths, is added to the bed if given.
    void set_bed(const DisplayBed& bed, const Field<float>* water_depth, int stride,
                 ViewOrder order);

    /// Draws into the bound target.
    void draw(const gl::Texture2D& colours, const Light& light, const Camera& camera,
              const TileSamples& tile) const;

  private:
    void build(const DisplayBed& bed, int stride, ViewOrder order);
    void draw_surface(const gl::Texture2D& colours) const;
    void draw_sides(const Light& light, const Camera& camera) const;

    View view_;
    Block block_;
    bool grainy_;
    gl::Program surface_program_;
    gl::Program side_program_;
    gl::Texture2D grain_;
    gl::VertexArray surface_array_;
    gl::VertexArray side_array_;
    gl::Buffer places_;
    gl::Buffer heights_;
    gl::Buffer triangles_;
    gl::Buffer side_places_;
    gl::Buffer side_heights_;
    gl::Buffer side_triangles_;
    TerrainMesh mesh_;
    Mask nodata_;
    int stride_ = 0;
    ViewOrder order_;
};

}  // namespace fumon
