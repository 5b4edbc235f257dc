// A block drawn by fumon's own rasteriser: a visibility buffer first, shading after it, a band of
// rows at a time.
//
//   vertices ─ project ─► 1/256 sample ─ bin ─► a band's triangles ─ rasterise ─► samples ─► pixels
//                              └─ outside the guard band: clip, then bin
//
// 1. A band is 16 rows of pixels, 32 of samples. Visibility stays in the cache, never kept for the
//    whole picture; each thread takes the next band and works in a Scratch of its own.
// 2. A sample is one word, see below. The larger word is the nearer one, so that neither the order
//    of triangles nor tiles nor threads change a sample's visibility.
// 3. Only visible surfaces are shaded. A pixel whose four samples lie close together takes
//    one texture lookup midway between them; other pixels of the surface are listed (EdgePixels)
//    and take four.
// 4. A surface under water is shaded by OpenGL, once a pixel, at the positions of a GBuffer. Where
//    the samples of a pixel see two points far apart, as at a brink before far ground, it has two
//    texels there, which are mixed by their shares of the samples.
// 5. Sides and background are OpenGL's, drawn only in the rectangles where they are seen; finish()
//    mixes them into the pixels that are left.
//
//   row of samples 2j + 1   │ A nw │ A ne │ B nw │ B ne │ …       of pixels A, B …
//   row of samples 2j       │ A sw │ A se │ B sw │ B se │ …       each Band::beyond words longer
//   a word                  │ 31 …  reversed z, a float  … 3 │ 2 … kind … 0 │
//   kinds                   0 nothing, 1 surface, 2 … 5 sides
//
// Source: visibility buffers are Burns & Hunt's (2013, J. Computer Graphics Techniques 2). Theirs
// name the triangle; this one keeps its depth, from which the position on the ray follows.

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/image.h"
#include "render/samples/block_vectors.h"
#include "render/samples/g_buffer.h"
#include "render/samples/resolve_vectors.h"
#include "render/samples/triangle_bins.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// Triangles of the block's surface and its four sides.
struct BlockMesh {
    struct Vertices {
        std::span<const float> positions;  ///< east and north by turns, 0 … 1 over the block
        std::span<const float> heights;    ///< block lengths
    };
    Vertices surface;
    Vertices sides;
    std::span<const std::uint32_t> surface_triangles;
    std::array<std::span<const std::uint32_t>, 4> side_triangles;
    glm::dvec2 extent;  ///< of the block, in its lengths
    bool double_sided;  ///< of a triangle: else it is seen from outside alone
};

/// The surface's display values and how much of the grain is seen, RGBA.
struct BlockTexture {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels;
};

/// Rasterises a block at 2 × 2 samples a pixel, and resolves its pixels.
/// Pixels that see the surface alone get their colours here, from the shaded bed; those of a block
/// with water are shaded by others, one by one, from the points that they show. Sides and
/// surroundings are drawn by others, where there is something to be seen of them. What a sample
/// sees does not depend on tiles, on the order of triangles, on threads and on the processor.
class BlockRasteriser {
  public:
    /// `grain`: of the strength that a whole one has, 0: none.
    explicit BlockRasteriser(float grain) : grain_(grain) {}

    static constexpr int first_side = 2;  ///< kind of a sample's surface

    /// Takes the grain's texels over the block, eastward and northward, and the shaded bed.
    void set_texture(glm::vec2 grain_texels, BlockTexture& read);

    /// Rasterises a tile and shades the pixels that show the surface alone. All of the
    /// block lies before the camera, as needs_no_clipping() says.
    void rasterise(const BlockMesh& shape, const Camera& camera, const Tile& tile, WorkerPool& pool,
                   Image& image);

    /// How positions on a block's surface are found.
    struct GBufferSetup {
        const Camera& camera;
        glm::ivec2 picture;  ///< pixels of the whole of it
        glm::dvec2 heights;  ///< of the surface: the lowest, and how much higher the highest
        g_buffer_vectors::SplitRules rules;
    };
    /// As rasterise(), of a block whose surface is shaded by its pixels: finds which points these
    /// show. The block may reach behind a camera in perspective.
    void fill_g_buffer(const BlockMesh& shape, const Tile& tile, const GBufferSetup& setup,
                       WorkerPool& pool, GBuffer& out);
    /// Takes the colours of these, which some of them are mixed from.
    void resolve_shading(GBuffer& shaded, WorkerPool& pool, Image& image);

    /// Rectangles of the tile, rows from above, in which surroundings are seen.
    [[nodiscard]] std::vector<Tile> background_rectangles() const;
    /// The part of the tile where one of the sides is seen; an empty one where it is not.
    [[nodiscard]] const Tile& side_rectangle(int side) const {
        return sides_[static_cast<std::size_t>(side)].part;
    }
    /// Room for the colours of that part, RGBA of 8 bits, rows upward.
    [[nodiscard]] std::vector<std::uint32_t>& side_colours(int side) {
        return sides_[static_cast<std::size_t>(side)].colours;
    }

    /// The pixels that rasterise() left, over the tile's surroundings, rows from above; in a
    /// transparent picture over nothing.
    void finish(const std::vector<ColourPlanes>& behind, WorkerPool& pool, Image& image) const;

  private:
    struct Span {
        int begin;
        int end;
        std::uint8_t state;  // as block_vectors::Pixel
    };
    struct MixedPixel {
        std::array<std::uint32_t, 3> sums;
        std::uint32_t kinds;
    };
    struct Split {
        std::int32_t pixel;
        std::array<glm::vec4, 2> positions;
        std::array<float, 2> shares;  // of the samples
        int first = 0;                // texel of its points; −1: none
    };
    struct Row {
        std::vector<Span> spans;  // of pixels that are not finished
        std::vector<MixedPixel> mixed;
        std::vector<Split> splits;  // pixels that see two points of a surface shaded by pixels
        glm::ivec2 covered{0};      // from which pixel to which it is seen
    };
    struct Side {
        Tile part;
        std::vector<std::uint32_t> colours;
    };
    /// What a thread works in.
    struct Scratch {
        explicit Scratch(int pixels);

        std::size_t stride;
        std::vector<std::uint32_t> samples;
        ColourPlanes planes;
        std::vector<std::uint8_t> state;
        block_vectors::EdgePixels edges;
        g_buffer_vectors::MultiSurfacePixels listed;
    };

    static constexpr int factor = 2;      // samples along each side of a pixel
    static constexpr int band_rows = 16;  // of pixels: their samples stay in the cache

    static std::uint8_t root_of_mean(std::uint32_t sum, std::uint32_t count);
    static Split split_pixel(const g_buffer_vectors::MultiSurfacePixels& listed, std::size_t i,
                             const g_buffer_vectors::SplitRules& rules, const glm::vec3& forward);
    void set_up_triangles(const BlockMesh& shape, const Camera& camera, const glm::ivec2& picture,
                          WorkerPool& pool);
    void for_bands(WorkerPool& pool,
                   const std::function<void(int band, Scratch& scratch)>& work) const;
    [[nodiscard]] block_vectors::PixelRow pixel_row(int row, int band, const Camera& camera,
                                                    const Scratch& scratch) const;
    [[nodiscard]] block_vectors::Rays height_rays(const Camera& camera, const glm::dvec2& heights,
                                                  int row_of_samples) const;
    void list_unfinished(Row& row, const std::uint8_t* state) const;
    void fill_band(int band, const GBufferSetup& setup, Scratch& scratch, GBuffer& out);
    void bound_covered(GBuffer& out);
    void rasterise_band(int band, Scratch& scratch) const;
    void shade_band(int band, const Camera& camera, Scratch& scratch, Image& image);
    void list_spans(Row& row, const std::uint8_t* state, const block_vectors::EdgePixels& edges,
                    std::uint8_t* rgb) const;
    void find_sides();
    [[nodiscard]] std::uint32_t colour_of(int kind, int x, int y) const;
    std::uint32_t finish_mixed(const MixedPixel& mixed, int x, int y,
                               const std::vector<ColourPlanes>* behind, std::uint8_t* pixel) const;

    float grain_;
    glm::vec2 grain_texels_{0.0F};
    std::vector<std::uint32_t> packed_grain_;
    BlockTexture colours_;
    Tile tile_;
    glm::dvec2 extent_{1.0};
    glm::ivec2 samples_{0};       // of the whole picture
    glm::ivec2 first_sample_{0};  // of the tile, from the picture's lower left
    int covered_rows_ = 0;        // of pixels that show a surface shaded by pixels
    rasteriser_vectors::ProjectedVertices vertices_;
    TriangleBins bins_;
    // Of triangles that reach behind the camera, or far aside: what is left of them.
    rasteriser_vectors::ProjectedVertices clipped_vertices_;
    std::array<std::vector<std::uint32_t>, 5> clipped_;
    TriangleBins clipped_bins_;
    std::vector<Row> rows_;  // the upper first
    std::array<Side, 4> sides_;
};

/// Whether all of a box, in the block's lengths, lies between the camera's depths and not far
/// outside the picture.
bool needs_no_clipping(const Camera& camera, const glm::dvec3& lowest, const glm::dvec3& highest);

}  // namespace fumon
