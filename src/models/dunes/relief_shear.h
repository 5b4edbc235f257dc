#pragma once

#include <vector>

#include "base/grid.h"
#include "models/dunes/wind_shadow.h"
#include "models/dunes/wind_turns.h"
#include "numerics/plane_filter.h"

namespace fumon {

class WorkerPool;

/// The linear response of the wind's shear stress on the bed to its relief (Jackson & Hunt 1975;
/// Kroy, Sauermann & Herrmann 2002), for each wave of the bed with the wave vector k and its
/// component k_w along the wind:
///
///     τ/τ0 − 1 = (A + iB sgn k_w) (k_w² / |k|) ĥ exp(−(dx k_x / 2√2)² − (dy k_y / 2√2)²)
///
/// The stress is highest ahead of the crests, by atan(B/A) of a wave. The last factor takes away
/// what the grid cannot resolve.
///
/// The transform sees any bed as periodic. Across open edges the bed goes on for half its length,
/// over which its height passes smoothly from that of one edge to that of the other, so that what
/// is at one edge is far from the other.
class ReliefShear {
  public:
    ReliefShear(const DuneGround& ground, double in_phase, double ahead, WorkerPool& pool);

    /// Replaces heights in metres by τ/τ0 − 1.
    void apply(Grid& plane, const BlowingWind& wind);

  private:
    void respond(Grid& plane, const BlowingWind& wind);
    void go_on_past_edges(const Grid& plane);

    int nx_;  ///< of the bed
    int ny_;
    DuneGround ground_;  ///< with what goes on past the edges
    double in_phase_;
    double ahead_;
    WorkerPool& pool_;
    Grid extended_;  ///< empty where nothing goes on past the edges
    PlaneFilter filter_;
    std::vector<double> smoothing_x_;  ///< of the modes along x
    std::vector<double> smoothing_y_;
};

}  // namespace fumon
