#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/air/air_plane.h"
#include "numerics/rectangle_poisson.h"

namespace fumon {

class WorkerPool;

/// One known of a node's pressure equation: weight × the pressure of node k of column i.
struct PressureTerm {
    int i = 0;
    int k = 0;
    double weight = 0.0;
};

/// The compact Laplacian Σ_neighbours p − 4p at an air node (Terada 2025, eq. 33), with the
/// boundaries put in: periodic in x, p of the lid's node = p below it (eq. 24, whose other part
/// belongs to the right-hand side), and p just under the bed from the nodes above it (`bed`).
std::vector<PressureTerm> pressure_equation(const AirPlane& plane, BedPressure bed, int i, int k);

/// Solves the pressure equations of all air nodes, exactly up to rounding. They fix p up to a
/// constant, and have a solution only where the right-hand side agrees with them: a constant is
/// subtracted from it so that it does, and p is 0 at the first column's lowest air node.
class AirPoisson {
  public:
    AirPoisson(const AirPlane& plane, BedPressure bed, WorkerPool& pool);

    /// Both on the plane's nodes; only those of the air are read and written.
    void solve(std::span<const double> right_side, std::span<double> pressure);

  private:
    [[nodiscard]] int lowest(int i) const {
        return plane_.under_bed[static_cast<std::size_t>(i)] + 1;
    }
    /// Where the rectangle keeps node k ≥ 1 of column i.
    [[nodiscard]] std::size_t at(int i, int k) const {
        return static_cast<std::size_t>(i) * rectangle_.stride() + static_cast<std::size_t>(k - 1);
    }
    void invert_departures();
    void solve_pinned(std::span<const double> right_side);

    AirPlane plane_;
    WorkerPool& pool_;
    RectanglePoisson rectangle_;
    int near_bed_;  ///< nodes of a column up to which departures reach
    std::vector<double> b_;
    std::vector<double> p_;
    std::vector<std::vector<PressureTerm>> departures_;  ///< of each column's lowest air node
    std::vector<double> inverse_;                        ///< nx × nx, by columns
    std::vector<double> strengths_;
    std::vector<double> of_constant_;  ///< the pinned solution for 1 everywhere
};

}  // namespace fumon
