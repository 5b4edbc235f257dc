#pragma once

#include <vector>

#include "gl/dynamic_buffer.h"
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
    /// `fixed`: see fixed_uniforms().
    TerrainLayer(const View& view, const Block& block, const gl::Constants& fixed);

    /// Takes the heights of a snapshot and meshes the bed. `water_depth`, in block lengths, is
    /// added to the bed if given.
    void set_bed(const DisplayBed& bed, const Field<float>* water_depth, const Camera& camera);

    /// Draws what each sample sees into the bound target of two floats and its cleared stencils:
    /// of the surface the place, 0 … 1 east and north (stencil 1), of the sides the face and place
    /// on it, see side.vert.glsl, and the height (stencil 2).
    void draw_seen(const Camera& camera, const TileSamples& tile) const;

    /// Colours, in the bound target, the samples whose stencils that has set: each sample once,
    /// however many triangles its neighbours see.
    void colour_seen(const gl::Texture2D& seen, const gl::Texture2D& colours, const Light& light,
                     const Camera& camera) const;

  private:
    void build(const DisplayBed& bed, int stride);
    void set_sides(const std::vector<SideFace>& faces, const DisplayBed& bed);
    void colour_surface(const gl::Texture2D& colours) const;
    void colour_sides(const Light& light, const Camera& camera) const;

    View view_;
    Block block_;
    bool grainy_;
    gl::Program surface_program_;
    gl::Program side_program_;
    gl::Program surface_colours_;
    gl::Program side_colours_;
    gl::Texture2D grain_;
    gl::VertexArray surface_array_;
    gl::VertexArray side_array_;
    gl::VertexArray no_attributes_;
    gl::DynamicBuffer places_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer heights_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer triangles_{GL_ELEMENT_ARRAY_BUFFER};
    gl::DynamicBuffer side_corners_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer side_triangles_{GL_ELEMENT_ARRAY_BUFFER};
    gl::DynamicBuffer faces_{GL_TEXTURE_BUFFER};  // see side.frag.glsl
    gl::Texture faces_texture_;
    TerrainLattice lattice_;
    std::vector<SideFace> rim_;
    TerrainMesher mesher_;
    std::vector<float> surface_;  // heights of the lattice's vertices, water included
    GLsizei indices_ = 0;
    GLsizei side_indices_ = 0;
    Mask nodata_;
    int stride_ = 0;
};

}  // namespace fumon
