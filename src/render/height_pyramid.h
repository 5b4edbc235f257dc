#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// Heights of a periodic bed, and their means over squares of 2, 4, 8 … cells.
class HeightPyramid {
  public:
    explicit HeightPyramid(const Field<float>& heights);

    [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }
    /// Between the four nearest means of a level. `east` and `north` count periods: 0 and 1 are the
    /// bed's two ends.
    [[nodiscard]] float at(int level, double east, double north) const;
    [[nodiscard]] float highest() const { return highest_; }

  private:
    std::vector<Field<float>> levels_;
    float highest_ = 0.0F;
};

}  // namespace fumon
