#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/dynamic_buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame/tile_samples.h"
#include "render/ground/terrain_mesh.h"
#include "render/light/light.h"
#include "render/samples/block_rasteriser.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// The block: the bed's surface, coloured by a shaded texture, and its sides.
class TerrainLayer {
  public:
    /// `fixed`: see fixed_uniforms(). `by_pixels`: the surface gets its colours from WaterPixels.
    TerrainLayer(const View& view, const Block& block, const gl::Constants& fixed,
                 bool by_pixels = false);

    /// Takes the heights of a snapshot and meshes the bed. `water_depth`, in block lengths, is
    /// added to the bed if given.
    void set_bed(const DisplayBed& bed, const Field<float>* water_depth, const Camera& camera);

    /// The depth of water at which the bed is half hidden, in block lengths, and how turbid the
    /// water of cuts is, 0 clear … 1 muddy.
    void set_water(float clarity, float turbidity) {
        clarity_ = clarity;
        turbidity_ = turbidity;
    }

    /// Of the surface, water included: the lowest, and how much higher the highest.
    [[nodiscard]] const glm::vec2& height_span() const { return height_span_; }
    /// The corners of what the surface fills, in block lengths.
    [[nodiscard]] glm::vec3 low() const {
        return {-0.5 * block_.width_x, -0.5 * block_.width_y, height_span_.x};
    }
    [[nodiscard]] glm::vec3 high() const {
        return {0.5 * block_.width_x, 0.5 * block_.width_y, height_span_.x + height_span_.y};
    }

    /// Whether the bed ends around cells without data.
    [[nodiscard]] bool has_rim() const { return !rim_.empty(); }

    /// Rasterises visibility into the bound target of two numbers 0 … 1 and its cleared stencils:
    /// on the surface the position east and north, on the sides the ground and the surface above,
    /// see block/side.vert.glsl. The stencil distinguishes surface and sides.
    void rasterise(const Camera& camera, const TileSamples& tile);

    /// Colours, in the bound target, the samples whose stencils that has set: each sample once,
    /// however many triangles its neighbours see. `colours`: those of BedShading, or of
    /// WaterPixels, whose pixels begin at the sample `offset`.
    void shade_samples(const gl::Texture2D& visibility, const gl::Texture2D& colours,
                       const Light& light, const Camera& camera, const TileSamples& tile,
                       const glm::ivec2& offset = {});

    /// Binds the sand's grain to a unit and sets how it is seen, of the program in use.
    void set_grain(const gl::Program& program, int unit) const;

    /// The same triangles, for BlockRasteriser; of a block without rim, until the next bed.
    [[nodiscard]] BlockMesh shape(const Camera& camera) const;
    /// Whether BlockRasteriser can take it from there.
    [[nodiscard]] bool needs_no_clipping(const Camera& camera) const;
    /// Texels of the grain over the block, eastward and northward.
    [[nodiscard]] glm::vec2 grain_over_block() const;
    /// By how much it darkens and lightens, 0: not at all.
    [[nodiscard]] float grain_strength() const;

    /// Colours, in the bound target, all pixels that may see one of the sides (west, east, south,
    /// north), and some around. `tile` counts in pixels.
    void shade_side(int side, const Light& light, const Camera& camera, const TileSamples& tile);

    /// Draws into the bound target, cleared to 0, which point each pixel sees, see
    /// position/position.frag.glsl; by the programs of position/bed_position.vert.glsl and
    /// position/side_position.vert.glsl.
    void rasterise_positions(const gl::Program& surface, const gl::Program& sides,
                             const Camera& camera, const TileSamples& tile);

  private:
    void build(const DisplayBed& bed, int stride);
    void set_sides(const std::vector<SideFace>& borders);
    void set_transform(const gl::Program& program, const Camera& camera,
                       const TileSamples& tile) const;
    /// Of the bound array, `count` indices from the place `first` on.
    static void draw_triangles(std::size_t first, std::size_t count);
    [[nodiscard]] bool backs_are_hidden(const Camera& camera) const;
    void set_surface(const gl::Program& program, const gl::Texture2D& colours) const;
    void set_sides(const gl::Program& program, const Light& light, const Camera& camera) const;

    View view_;
    Block block_;
    bool grainy_;
    bool by_pixels_;
    gl::Constants fixed_;
    /// What draws, made as it is needed: by samples, and by pixels.
    struct SamplePrograms {
        gl::Program surface;
        gl::Program sides;
        gl::Program surface_colours;
        gl::Program side_colours;
    };
    struct Box {
        glm::dvec3 lowest;
        glm::dvec3 highest;
    };
    [[nodiscard]] Box box_around() const;  ///< the bed and its sides
    const SamplePrograms& by_sample();
    void upload_surface();
    std::optional<SamplePrograms> by_sample_;
    /// Of the sides, for shade_side(): rectangles a little beyond what is drawn of them.
    struct Strips {
        gl::Program program;
        gl::VertexArray array;
        gl::DynamicBuffer corners{GL_ARRAY_BUFFER};
        gl::Texture2D ground;  // along each side, 0 … 1 over the range of heights
    };
    const Strips& strips();
    std::optional<Strips> strips_;
    bool strips_made_ = false;  // of this bed
    std::optional<gl::Texture2D> grain_;
    gl::VertexArray surface_array_;
    gl::VertexArray side_array_;
    gl::VertexArray no_attributes_;
    gl::DynamicBuffer positions_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer heights_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer triangles_{GL_ELEMENT_ARRAY_BUFFER};
    gl::DynamicBuffer side_corners_{GL_ARRAY_BUFFER};
    gl::DynamicBuffer side_triangles_{GL_ELEMENT_ARRAY_BUFFER};
    TerrainLattice lattice_;
    std::vector<std::uint32_t> moved_;  // vertices of the lattice, to the outline
    std::vector<SideFace> rim_;
    TerrainMesher mesher_;
    std::vector<float> ground_;   // heights of the lattice's vertices, block lengths
    std::vector<float> surface_;  // heights of the lattice's vertices, water included
    TerrainMesh mesh_;
    bool uploaded_ = false;              // these two
    std::vector<float> side_positions_;  // of the corners of sides, east and north by turns
    std::vector<float> side_heights_;
    GLsizei indices_ = 0;
    float clarity_ = 1.0F;
    float turbidity_ = 0.0F;
    bool watery_ = false;
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
    glm::vec2 height_span_{0.0F, 1.0F};
    Mask nodata_;
    int stride_ = 0;
};

}  // namespace fumon
