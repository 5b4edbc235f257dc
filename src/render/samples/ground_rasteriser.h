#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/samples/triangle_bins.h"
#include "render/samples/visibility_vectors.h"
#include "render/view/camera.h"

namespace fumon {

class WorkerPool;

/// Triangles of endless ground, whose corners are offsets from the eye, in the block's lengths.
struct GroundTriangles {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> near;  ///< three corners each
    std::span<const std::uint32_t> far;
};

/// Samples of a picture: a rectangle of them, which may reach beyond the picture.
struct SampleRectangle {
    glm::ivec2 picture{0};  ///< samples of the whole picture
    glm::ivec2 first{0};    ///< from the picture's lower left
    glm::ivec2 size{0};

    /// Samples from one row to the next: as many as are written at once, or a multiple.
    [[nodiscard]] std::size_t row() const {
        constexpr std::size_t together = 16;
        return (static_cast<std::size_t>(size.x) + together - 1) / together * together;
    }
    /// Numbers of a kind, one for each sample: by fours, of two samples in a row and of the two
    /// over them, so that a pixel of so many has them together.
    [[nodiscard]] std::size_t numbers() const {
        return stride() * ((static_cast<std::size_t>(size.y) + 1) / 2);
    }
    /// From two rows to the next two.
    [[nodiscard]] std::size_t stride() const { return 2 * row(); }
    /// Of a sample among them.
    [[nodiscard]] std::size_t index(std::size_t column, std::size_t row) const {
        return stride() * (row / 2) + 4 * (column / 2) + 2 * (row % 2) + column % 2;
    }
    /// Numbers of both kinds, see GroundRasteriser::rasterise().
    [[nodiscard]] std::size_t count() const { return 2 * numbers(); }
};

/// Where the ground is that a sample sees: (first + column · right + row · up) / reversed_z from
/// the eye, columns and rows counted from the picture's lower left, whatever the rectangle.
struct SampleRays {
    glm::dvec3 first;
    glm::dvec3 right;
    glm::dvec3 up;
};

/// Of a camera in perspective without a lens, whose near_depth is where reversed_z is 1.
SampleRays sample_rays(const Camera& camera, const glm::ivec2& picture);

/// Rasterises the visibility of endless ground. The result does not depend on the rectangle, the
/// threads or the processor.
class GroundRasteriser {
  public:
    static constexpr std::uint32_t near_kind = 1;
    static constexpr std::uint32_t far_kind = 2;

    /// Records the visibility of each sample as two numbers: reversed z, a float, whose
    /// lowest three bits (rasteriser_vectors::kind_bits) are the kind, 0: nothing; and, as a
    /// float, its length on the ground along the view. First all of the one kind, then all of
    /// the other, each at its SampleRectangle::index(). The camera's eye is the offsets'
    /// origin; ground nearer than its near_depth is left out.
    void rasterise(const GroundTriangles& ground, const Camera& camera,
                   const SampleRectangle& samples, WorkerPool& pool, std::uint32_t* out);

  private:
    void clip(const GroundTriangles& ground, const visibility_vectors::Perspective& projection);
    void rasterise_bands(const Camera& camera, const SampleRectangle& samples, WorkerPool& pool,
                         std::uint32_t* out) const;

    rasteriser_vectors::ProjectedVertices vertices_;
    TriangleBins bins_;
    // Of triangles that reach beyond near_depth, or far aside: what is left of them.
    rasteriser_vectors::ProjectedVertices clipped_vertices_;
    std::vector<std::uint32_t> clipped_near_;
    std::vector<std::uint32_t> clipped_far_;
    TriangleBins clipped_bins_;
};

}  // namespace fumon
