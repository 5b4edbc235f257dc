#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/image.h"
#include "render/samples/block_vectors.h"
#include "render/samples/sample_vectors.h"
#include "render/samples/triangle_bands.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// Triangles of the block's surface and its four sides.
struct BlockShape {
    struct Corners {
        std::span<const float> places;   ///< east and north by turns, 0 … 1 over the block
        std::span<const float> heights;  ///< block lengths
    };
    Corners surface;
    Corners sides;
    std::span<const std::uint32_t> surface_triangles;
    std::array<std::span<const std::uint32_t>, 4> side_triangles;
    glm::dvec2 extent;  ///< of the block, in its lengths
    bool both_faces;    ///< of a triangle: else it is seen from outside alone
};

/// The surface's display values and how much of the grain is seen, RGBA.
struct BlockColours {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels;
};

/// A picture of a dry block, of 2 × 2 samples a pixel: what each of them sees, and pixels from
/// that. Pixels that see the surface alone get their colours here, from the shaded bed; sides and
/// surroundings are drawn by others, where there is something to be seen of them. What a sample
/// sees does not depend on tiles, on the order of triangles, on threads and on the processor.
class BlockSamples {
  public:
    /// `grain`: of the strength that a whole one has, 0: none.
    explicit BlockSamples(float grain) : grain_(grain) {}

    static constexpr int first_side = 2;  ///< kind of what samples see

    /// Takes the grain's texels over the block, eastward and northward, and the shaded bed.
    void set_colours(glm::vec2 grain_texels, BlockColours& read);

    /// Finds what the pixels of a tile see and colours those that see the surface alone. All of the
    /// block lies before the camera, as lies_before() says.
    void see(const BlockShape& shape, const Camera& camera, const Tile& tile, WorkerPool& pool,
             Image& image);

    /// Rectangles of the tile, rows from above, in which surroundings are seen.
    [[nodiscard]] std::vector<Tile> open_parts() const;
    /// The part of the tile where one of the sides is seen; an empty one where it is not.
    [[nodiscard]] const Tile& part_of_side(int side) const {
        return sides_[static_cast<std::size_t>(side)].part;
    }
    /// Room for the colours of that part, RGBA of 8 bits, rows upward.
    [[nodiscard]] std::vector<std::uint32_t>& colours_of_side(int side) {
        return sides_[static_cast<std::size_t>(side)].colours;
    }

    /// The pixels that see() left, over the tile's surroundings, rows from above; in a transparent
    /// picture over nothing.
    void finish(const std::vector<ColourPlanes>& behind, WorkerPool& pool, Image& image) const;

  private:
    struct Run {
        int begin;
        int end;
        std::uint8_t state;  // as block_vectors::Pixel
    };
    struct Mixed {
        std::array<std::uint32_t, 3> sums;
        std::uint32_t kinds;
    };
    struct Row {
        std::vector<Run> runs;  // of pixels that are not finished
        std::vector<Mixed> mixed;
    };
    struct Side {
        Tile part;
        std::vector<std::uint32_t> colours;
    };
    struct Room;

    static std::uint8_t root_of_mean(std::uint32_t sum, std::uint32_t count);
    void place(const BlockShape& shape, const Camera& camera, const Image& image, WorkerPool& pool);
    void draw_band(int band, Room& room) const;
    void colour_band(int band, const Camera& camera, Room& room, Image& image);
    void list_runs(Row& row, const std::uint8_t* state, const block_vectors::Edges& edges,
                   std::uint8_t* rgb) const;
    void find_sides();
    [[nodiscard]] std::uint32_t colour_of(int kind, int x, int y) const;
    std::uint32_t finish_mixed(const Mixed& mixed, int x, int y,
                               const std::vector<ColourPlanes>* behind, std::uint8_t* pixel) const;

    float grain_;
    glm::vec2 grain_texels_{0.0F};
    std::vector<std::uint32_t> packed_grain_;
    BlockColours colours_;
    Tile tile_;
    glm::dvec2 extent_{1.0};
    glm::ivec2 samples_{0};       // of the whole picture
    glm::ivec2 first_sample_{0};  // of the tile, from the picture's lower left
    triangle_vectors::Corners corners_;
    TriangleBands bands_;
    std::vector<Row> rows_;  // the upper first
    std::array<Side, 4> sides_;
};

/// Whether all of a box, in the block's lengths, lies between the camera's depths and not far
/// outside the picture.
bool lies_before(const Camera& camera, const glm::dvec3& lowest, const glm::dvec3& highest);

}  // namespace fumon
