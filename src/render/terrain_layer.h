#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
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

/// Of what a sample sees: a place on the block, or an offset from the eye over endless ground.
gl::TextureLayout seen_layout(Ground ground);

/// The block: the bed's surface, coloured by a shaded texture, and its sides.
class TerrainLayer {
  public:
    /// `fixed`: see fixed_uniforms().
    TerrainLayer(const View& view, const Block& block, const gl::Constants& fixed);

    /// Takes the heights of a snapshot and meshes the bed. `water_depth`, in block lengths, is
    /// added to the bed if given.
    void set_bed(const DisplayBed& bed, const Field<float>* water_depth, const Camera& camera);

    /// The depth of water at which the bed is half hidden, in block lengths.
    void set_clarity(float clarity) { clarity_ = clarity; }

    /// Whether the bed ends around cells without data.
    [[nodiscard]] bool has_rim() const { return !rim_.empty(); }

    /// Draws what each sample sees into the bound target of two numbers 0 … 1 and its cleared
    /// stencils: of the surface the place east and north, of the sides the ground and the surface
    /// over it, see block/side.vert.glsl. The stencil says which of them it is.
    void draw_seen(const Camera& camera, const TileSamples& tile);

    /// Colours, in the bound target, the samples whose stencils that has set: each sample once,
    /// however many triangles its neighbours see.
    void colour_seen(const gl::Texture2D& seen, const gl::Texture2D& colours, const Light& light,
                     const Camera& camera, const TileSamples& tile);

    /// The same, of 2 × 2 samples a pixel, for colour_pixels(): into a target of one whole number,
    /// see block/seen_kind.frag.glsl.
    void draw_kinds(const Camera& camera, const TileSamples& tile);

    /// Colours pixels, in the bound target, cleared to 0, and its cleared depths: one look at the
    /// bed for each that sees one piece of the surface, one colour for each side that a pixel sees,
    /// and samples by themselves where surfaces meet. Squares of display values, times the share of
    /// the pixel that is covered, and that share. `tile` counts in pixels. Of a block without rim.
    void colour_pixels(const gl::Texture2D& seen, const gl::Texture2D& colours, const Light& light,
                       const Camera& camera, const TileSamples& tile);

    /// Calls `draw` so that it reaches only pixels of the bound target, which has the depths of
    /// colour_pixels(), that this did not colour as wholes.
    static void beside_whole_pixels(const std::function<void()>& draw);

    /// Draws into the bound target, cleared to 0, which point each pixel sees, see
    /// places/place.frag.glsl; by the programs of places/bed_place.vert.glsl and
    /// places/side_place.vert.glsl.
    void draw_places(const gl::Program& surface, const gl::Program& sides, const Camera& camera,
                     const TileSamples& tile) const;

  private:
    void build(const DisplayBed& bed, int stride);
    void set_sides(const std::vector<SideFace>& borders, const DisplayBed& bed);
    void place(const gl::Program& program, const Camera& camera, const TileSamples& tile) const;
    /// Of the bound array, `count` indices from the place `first` on.
    static void draw_triangles(std::size_t first, std::size_t count);
    [[nodiscard]] bool no_back_is_seen(const Camera& camera) const;
    void set_surface(const gl::Program& program, const gl::Texture2D& colours) const;
    void set_sides(const gl::Program& program, const Light& light, const Camera& camera) const;

    View view_;
    Block block_;
    bool grainy_;
    gl::Constants fixed_;
    /// What draws, made as it is needed: by samples, and by pixels.
    struct SamplePrograms {
        gl::Program surface;
        gl::Program sides;
        gl::Program surface_colours;
        gl::Program side_colours;
    };
    struct PixelPrograms {
        gl::Program surface;
        gl::Program sides;
        gl::Program pixels;
        gl::Program edges;
        gl::Program side_pixels;
    };
    struct Box {
        glm::dvec3 lowest;
        glm::dvec3 highest;
    };
    [[nodiscard]] Box box_around() const;  ///< the bed and its sides
    const SamplePrograms& by_sample();
    const PixelPrograms& by_pixel();
    std::optional<SamplePrograms> by_sample_;
    std::optional<PixelPrograms> by_pixel_;
    gl::Texture2D grain_;
    gl::VertexArray surface_array_;
    gl::VertexArray side_array_;
    gl::VertexArray no_attributes_;
    gl::DynamicBuffer places_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer heights_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer triangles_{GL_ELEMENT_ARRAY_BUFFER};
    gl::DynamicBuffer side_corners_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer side_triangles_{GL_ELEMENT_ARRAY_BUFFER};
    TerrainLattice lattice_;
    std::vector<SideFace> rim_;
    TerrainMesher mesher_;
    std::vector<float> surface_;  // heights of the lattice's vertices, water included
    GLsizei indices_ = 0;
    float clarity_ = 1.0F;
    /// Faces with one stencil, as they are drawn and as they are coloured: by themselves, or where
    /// all are in one plane by one rectangle around them.
    struct Faces {
        GLint stencil;
        bool in_one_plane;
        std::vector<std::uint32_t> drawn;
        std::size_t first_drawn = 0;  // place in the buffer of indices
        std::vector<std::uint32_t> coloured;
        std::size_t first_coloured = 0;
    };
    std::vector<Faces> faces_;
    glm::vec2 height_range_{0.0F, 1.0F};
    Mask nodata_;
    int stride_ = 0;
};

}  // namespace fumon
