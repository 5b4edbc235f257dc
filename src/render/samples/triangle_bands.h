#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/samples/triangle_vectors.h"

namespace fumon {

class WorkerPool;

/// Triangles of one kind, three corners each.
struct TrianglePart {
    std::span<const std::uint32_t> triangles;
    std::size_t first_corner;  ///< from which theirs are counted
    std::uint32_t kind;
    bool both_faces;  ///< else those that look away from the eye are left out
};

/// Which triangles each band of rows of samples may see, so that bands are drawn one by one, by any
/// thread.
class TriangleBands {
  public:
    /// `first_row` in the picture; bands of `band_rows` rows, the last perhaps of fewer. Triangles
    /// with a corner that has no place are told by unplaced(). What parts point to outlives the
    /// drawing.
    void sort(const triangle_vectors::Corners& corners, std::vector<TrianglePart> parts,
              int first_row, int rows, int band_rows, WorkerPool& pool);

    /// The triangles of a part that were left out, in their order.
    [[nodiscard]] std::vector<std::uint32_t> unplaced(std::size_t part) const;

    /// What samples of a band see, in the same order whatever the pool.
    void draw(int band, const triangle_vectors::Corners& corners,
              const triangle_vectors::Band& of) const;

  private:
    struct Share {
        std::vector<std::vector<std::uint32_t>> listed;    // of each band and each part
        std::vector<std::vector<std::uint32_t>> unplaced;  // of each part
    };
    void sort_share(std::size_t share, std::size_t shares, const triangle_vectors::Corners& corners,
                    int first_row, int bands, int band_rows);

    std::vector<TrianglePart> parts_;
    std::vector<Share> shares_;
};

}  // namespace fumon
