#pragma once

#include <cstddef>
#include <vector>

#include "models/water/kernels/cip_vectors.h"

namespace fumon::cip {

/// What a thread holds while it walks up a block of columns: the last four rows of what a sub-step
/// reads and of what it works out on the way, so that they stay in the cache from one kernel to the
/// next. Rows go on `margin` cells beyond both ends of the block, and row(…) points at its first
/// cell.
class Strip {
  public:
    static constexpr int margin = 2;           ///< cells and rows beyond the block that it reads
    static constexpr int widest_block = 1024;  ///< cells

    enum Field {
        depth,  ///< before the sub-step, as are those up to v
        bed,
        u,
        v,
        advected_u,
        advected_v,
        next_u,
        next_v,
        gained_u,
        gained_v,
        u_gradient_x,  ///< advected
        u_gradient_y,
        v_gradient_x,
        v_gradient_y,
        faces_east,  ///< depth that passes a cell's face, m; [−1] is the block's first
        faces_north,
        fields
    };

    Strip() : values_(static_cast<std::size_t>(fields) * kept * stride) {}

    [[nodiscard]] double* row(Field field, int y) {
        const auto slot = static_cast<std::size_t>(y & (kept - 1));
        return values_.data() + (static_cast<std::size_t>(field) * kept + slot) * stride + margin;
    }
    [[nodiscard]] Stencil around(Field field, int y) {
        return {row(field, y - 1), row(field, y), row(field, y + 1)};
    }

  private:
    static constexpr int kept = 4;  // rows; a power of two
    static constexpr std::size_t stride = widest_block + 2 * margin + 4;

    std::vector<double> values_;
};

}  // namespace fumon::cip
