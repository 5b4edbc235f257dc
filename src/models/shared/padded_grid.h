#pragma once

#include "base/grid.h"

namespace fumon {

/// nx × ny values whose rows can be read two cells past either end, so that loops over a row need
/// no cases for its ends.
class PaddedGrid {
  public:
    static constexpr int margin = 2;

    PaddedGrid() = default;
    PaddedGrid(int nx, int ny) : nx_(nx), values_(nx + 2 * margin, ny) {}

    /// Cell 0 of row y; cells −2 … nx + 1 may be used.
    double* row(int y) { return values_.row(y).data() + margin; }
    [[nodiscard]] const double* row(int y) const { return values_.row(y).data() + margin; }

    /// Continues row y past its ends with its other side.
    void wrap(int y) {
        double* cells = row(y);
        for (int k = 1; k <= margin; ++k) {
            cells[-k] = cells[((nx_ - k) % nx_ + nx_) % nx_];
            cells[nx_ - 1 + k] = cells[(k - 1) % nx_];
        }
    }

    [[nodiscard]] std::span<const double> values() const& { return values_.values(); }
    std::span<const double> values() && = delete;
    /// What lies past the rows' ends too.
    std::span<double> all_values() { return values_.values(); }

  private:
    int nx_ = 0;
    Grid values_;
};

}  // namespace fumon
