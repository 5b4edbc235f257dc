#pragma once

#include <vector>

#include "base/grid.h"
#include "models/shared/padded_grid.h"

namespace fumon {

/// Carries the depth of periodic water with given velocities so that no water is lost and none is
/// borrowed: ∂h/∂t + ∇·(h u) = rain by fluxes through the cells' faces, second order in space and
/// time with the monotonised central limiter (van Leer 1977, J. Comput. Phys. 23). Where more
/// would leave a cell than it has, all that leaves is scaled down alike.
class DepthFlux {
  public:
    DepthFlux(int nx, int ny, double dx, double dy);

    /// Starts a sub-step of `dt` seconds with `rain` in m/s.
    void begin(double dt, double rain);
    /// Rows [begin, end) of the depth `after` the sub-step; `after` may not be `before`.
    void carry(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v, int begin,
               int end, Grid& after);
    /// After all rows: sees to cells that gave more than they had.
    void finish(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v, Grid& after);

  private:
    void moved_east(const PaddedGrid& before, const PaddedGrid& u, int y, double* faces) const;
    void moved_north(const PaddedGrid& before, const PaddedGrid& v, int y, double* faces) const;

    int nx_;
    int ny_;
    double dx_;
    double dy_;
    double dt_ = 0.0;
    double fallen_ = 0.0;          ///< rain of the sub-step, m
    std::vector<char> overdrawn_;  ///< rows where more would leave a cell than it has
};

}  // namespace fumon
