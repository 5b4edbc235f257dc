#pragma once

#include <memory>
#include <span>
#include <vector>

#include "models/air_bed.h"

namespace fumon {

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
    AirPoisson(const AirPlane& plane, BedPressure bed);
    ~AirPoisson();
    AirPoisson(const AirPoisson&) = delete;
    AirPoisson& operator=(const AirPoisson&) = delete;

    /// Both on the plane's nodes; only those of the air are read and written.
    void solve(std::span<const double> right_side, std::span<double> pressure);

  private:
    class Factors;
    std::unique_ptr<Factors> factors_;
};

}  // namespace fumon
