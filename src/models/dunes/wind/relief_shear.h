#pragma once

#include <vector>

#include "base/grid.h"
#include "models/dunes/wind/ground_filter.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// The linear response of the wind's shear stress on the bed to its relief (Jackson & Hunt 1975;
/// Kroy, Sauermann & Herrmann 2002), for each wave of the bed with the wave vector k and its
/// components k_w along the wind and k_n across it, to the left:
///
///     τ/τ0 − 1 = (A + iB sgn k_w) (k_w² / |k|) ĥ exp(−(dx k_x / 2√2)² − (dy k_y / 2√2)²)
///     τ_n/τ0   = C (k_w k_n / |k|) ĥ exp(…)
///
/// A wind not far above the threshold of transport, of u*t, moves sand as τ less a threshold that
/// slopes raise (Gadal et al. 2019), q ∝ τ/τ0 − t (1 + ∂h/∂w / μ) with t = (u*t/u*)² and μ = 0.63,
/// so that the drift varies as τ/τ0 − 1 less (t/μ) i k_w ĥ, both divided by 1 − t: B becomes B −
/// t/μ for waves across the wind, and relief counts 1/(1 − t) times.
///
/// The stress is highest ahead of the crests, by atan(B/A) of a wave. The last factor takes away
/// what the grid cannot resolve. Across the wind the stress is in phase with the bed (Hunt,
/// Leibovich & Richards 1988, of Durán & Moore's 2013 form the part that does not vanish with the
/// roughness); C is .7 of A for waves of 10 to 160 m and a roughness of 1 mm.
class ReliefShear {
  public:
    ReliefShear(const DuneGround& ground, double in_phase, double ahead, WorkerPool& pool);

    /// Replaces heights in metres by τ/τ0 − 1, or above a threshold by q/q0 − 1.
    void apply(Grid& plane, const BlowingWind& wind);

    /// Replaces heights in metres by τ_n/τ0.
    void apply_across(Grid& plane, const BlowingWind& wind, double across);

  private:
    [[nodiscard]] double scale(const GroundFilter::Wave& wave) const;

    double in_phase_;
    double ahead_;
    GroundFilter filter_;
    std::vector<double> smoothing_x_;  ///< of the modes along x
    std::vector<double> smoothing_y_;
};

}  // namespace fumon
