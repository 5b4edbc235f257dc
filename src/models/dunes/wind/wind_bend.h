#pragma once

#include <vector>

#include "base/grid.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/ground_filter.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// Which way the wind blows over each cell: a unit vector.
struct BentWind {
    Grid x;
    Grid y;
};

/// A wind of direction d, to whose left n lies, turned by a stress across it: along d + (τ_n/τ0) n,
/// by 45° at most.
void turn_by_stress(const Grid& across, const BlowingWind& wind, WorkerPool& pool, BentWind& bent);

/// Grains that hop over a slope across the wind come down it by a part of what they hop, since the
/// grains that they splash roll down (Hersen 2004: the drift across the wind is −D q ∂h/∂n): takes
/// D times the slope of the surface, to the left of the wind, from a stress across it.
void turn_down_slopes(const FixedPointGrid& surface, const DuneGround& ground,
                      const BlowingWind& wind, double deflection, WorkerPool& pool, Grid& across);

/// Throws KeyError for bends, and deflections on slopes, of hops that follow no shear stress.
void check_wind_bend(const DunesParameters& parameters);

/// The wind turned along the contours of the relief, after Paris et al. (2019) and Nilles, Günther
/// & Müller (2024): with the gradients g_i of the surface smoothed by Gaussians of standard
/// deviations of 100 and 25 m, and o_i, the one of ±(−∂_y, ∂_x) of it that points along the wind d,
///
///     w = Σ c_i ((1 − α_i) d + α_i k_i o_i),   α_i = min(|g_i|, 1),   c = .8, .2,   k = 3, .5,
///
/// and its direction. k_i are theirs, 30 and 5, for their strongest wind, of 10 m a step. Across
/// open edges the surface goes on as GroundFilter has it.
class ContourBend {
  public:
    ContourBend(const DuneGround& ground, WorkerPool& pool);

    void find(const FixedPointGrid& surface, const BlowingWind& wind, BentWind& bent);

  private:
    struct Scale {
        double deviation;  ///< m
        double weight;     ///< c
        double strength;   ///< k
        std::vector<double> kept_x;
        std::vector<double> kept_y;
    };
    void add(const Scale& scale, const BlowingWind& wind, BentWind& bent);

    DuneGround ground_;
    WorkerPool& pool_;
    GroundFilter filter_;
    std::vector<Scale> scales_;
    Grid smooth_;
};

}  // namespace fumon
