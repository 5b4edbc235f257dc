#pragma once

#include <cstddef>
#include <vector>

#include "base/grid.h"
#include "models/shared/bed_diffusion_vectors.h"
#include "models/shared/padded_grid.h"

namespace fumon {

class WorkerPool;

/// Solves (1 − r δ²) a = b along lines of n cells, δ² the second difference: periodic lines (by
/// Sherman & Morrison 1950) or lines whose ends nothing crosses.
class DiffusionLine {
  public:
    DiffusionLine() = default;
    DiffusionLine(int count, double r, bool periodic);

    [[nodiscard]] bool nothing_to_do() const { return r_ == 0.0 || inverse_.size() < 2; }
    /// Lines that lie `stride` apart, side by side in time: in place.
    void solve_rows(double* first, std::ptrdiff_t stride, int lines) const;
    /// Lines across rows, for bed_diffusion::cross_rows. Only where there is something to do.
    [[nodiscard]] bed_diffusion::Lines across_rows() const;

  private:
    double r_ = 0.0;
    bool periodic_ = false;
    std::vector<double> inverse_;  ///< of the pivots
    std::vector<double> closing_;  ///< the solution for the corner entries
    double closing_weight_ = 0.0;  ///< of a[0] and, times closing_end_, a[n − 1]
    double closing_end_ = 0.0;
};

/// ∂z/∂t = D ∇²z + a source over one sub-step by alternating directions (Peaceman & Rachford 1955):
/// implicit in x then in y, second order in time, stable for any sub-step. Periodic edges go on;
/// nothing crosses others. Keeps Σz but for the source and rounding.
class BedDiffusion {
  public:
    BedDiffusion(int nx, int ny, double diffusion_x, double diffusion_y, bool periodic_x,
                 bool periodic_y, WorkerPool& pool);

    /// Of the next calls: diffusion in cells²/s times dt. Cheap where it has not changed.
    void prepare(double dt);

    /// Rows that first_half works on side by side.
    static constexpr int rows_at_once = 8;

    /// First half, on rows [begin, end): explicit in y, with the source, implicit in x. The first
    /// rows of `change` hold the source · dt of these.
    void first_half(const Grid& bed, const Grid& change, int begin, int end);
    /// Second half, on all rows, after all first halves.
    void second_half(Grid& bed);

  private:
    [[nodiscard]] std::ptrdiff_t stride() const { return nx_ + 2 * PaddedGrid::margin; }

    int nx_;
    int ny_;
    double diffusion_x_;
    double diffusion_y_;
    bool periodic_x_;
    bool periodic_y_;
    WorkerPool& pool_;
    double dt_ = -1.0;
    double rx_ = 0.0;
    double ry_ = 0.0;
    DiffusionLine along_x_;
    DiffusionLine along_y_;
    PaddedGrid half_way_;
};

}  // namespace fumon
