#pragma once

#include <vector>

#include "models/padded_grid.h"
#include "terrain/grid.h"

namespace fumon {

class WorkerPool;

/// Carries the depth of periodic water with given velocities so that no water is lost and none is
/// borrowed: ∂h/∂t + ∇·(h u) = rain by fluxes through the cells' faces, second order in space and
/// time with the monotonised central limiter (van Leer 1977, J. Comput. Phys. 23). Where more
/// would leave a cell than it has, all that leaves is scaled down alike.
class DepthFlux {
  public:
    DepthFlux(int nx, int ny, double dx, double dy, WorkerPool& pool);

    /// The depth `before`, (u, v) and the rest in metres and seconds; `after` may not be `before`.
    void carry(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v, double dt,
               double rain, Grid& after);

  private:
    void carry_rows(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v, double dt,
                    double rain, int begin, int end, Grid& after);
    void limit_outflow(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v,
                       double dt, double rain, Grid& after);
    void moved_east(const PaddedGrid& before, const PaddedGrid& u, double dt, int y,
                    double* faces) const;
    void moved_north(const PaddedGrid& before, const PaddedGrid& v, double dt, int y,
                     double* faces) const;

    int nx_;
    int ny_;
    double dx_;
    double dy_;
    WorkerPool& pool_;
    std::vector<char> overdrawn_;  ///< rows where more would leave a cell than it has
};

}  // namespace fumon
