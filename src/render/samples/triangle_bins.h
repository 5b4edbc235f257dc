// Sort-middle binning (Molnar, Cox, Ellsworth & Fuchs 1994): triangles are sorted into bands of
// rows once, then any thread rasterises any band. Each thread sorts an equal share of all triangles
// into lists of its own, so that none waits for another; a band walks these lists one after the
// other. Their order does not matter, as the nearest triangle is a maximum (rasteriser_vectors.h).

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/samples/rasteriser_vectors.h"

namespace fumon {

class WorkerPool;

/// Triangles of one kind, three corners each.
struct TriangleGroup {
    std::span<const std::uint32_t> triangles;
    std::size_t first_vertex;  ///< from which theirs are counted
    std::uint32_t kind;
    bool double_sided;  ///< else those that look away from the eye are left out
};

/// Which triangles each band of rows of samples may see, so that bands are drawn one by one, by any
/// thread.
class TriangleBins {
  public:
    /// `first_row` in the picture; bands of `band_rows` rows, the last perhaps of fewer. Triangles
    /// with a corner that cannot be projected are listed by needing_clipping(). The arrays of the
    /// parts outlive the drawing.
    void bin(const rasteriser_vectors::ProjectedVertices& vertices,
             std::vector<TriangleGroup> parts, int first_row, int rows, int band_rows,
             WorkerPool& pool);

    /// The triangles of a part that were left out, in their order.
    [[nodiscard]] std::vector<std::uint32_t> needing_clipping(std::size_t part) const;

    /// What samples of a band see, in the same order whatever the pool.
    void rasterise(int band, const rasteriser_vectors::ProjectedVertices& vertices,
                   const rasteriser_vectors::Band& of) const;

  private:
    struct BinShare {
        std::vector<std::vector<std::uint32_t>> listed;            // of each band and each part
        std::vector<std::vector<std::uint32_t>> needing_clipping;  // of each part
    };
    void bin_share(std::size_t share, std::size_t shares,
                   const rasteriser_vectors::ProjectedVertices& vertices, int first_row, int bands,
                   int band_rows);

    std::vector<TriangleGroup> parts_;
    std::vector<BinShare> shares_;
};

}  // namespace fumon
