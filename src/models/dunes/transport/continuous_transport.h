#pragma once

#include <cstdint>

#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dune_ground.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/transport/saltation.h"
#include "models/dunes/transport/saturation_hops.h"
#include "models/dunes/transport/wind_over_bed.h"
#include "models/dunes/wind/wind_schedule.h"

namespace fumon {

class WorkerPool;

/// Drift without random numbers, after Nilles, Günther & Müller (2024). In a step each cell gives a
/// layer
///
///     e = min(e0 f (1 − r), sand there)
///
/// to the air. Then all sand in the air moves a few times by L along the wind, spread over 3 × 3
/// cells (HopSpread), and of what arrives in a cell the share s ends its hop there, of which
/// max(r, p) stays; the rest moves on. r is the wind shadow (0 … 1), p that of sand or of rock,
/// blended where rock has a thin cover, f the lift's factor. Over flat sand the drift is saturated
/// at e0 L / (s p) a step, and it follows a change of f by ∂q/∂x = (q_sat − q) / ℓ with ℓ =
/// model.saturation_length, from which L and s follow (SaturationHops). With
/// model.saturation_length = "hops" there is one move a step, s is 1 and L model.hop_length: the
/// number of hops is then geometric and the drift follows over L (2 − p) / (2 p), in parts of L.
///
/// Grains that hop over a slope also drift down it: a cell gives to each neighbour on the same
/// surface that is lower by d over a distance dx the share c q0 Δt / dx² of d, where q0 is the
/// saturated drift over flat sand, and no more than a quarter of its sand. That diffusion, which
/// stands for the deflection of grains on slopes, takes away what varies from cell to cell.
///
/// Under plants less is lifted and more stays (see Plants); where they slow the wind, as much less
/// drifts down slopes as is lifted (see PlantShelter). Where the wind before a wall is u of
/// what it would be (see WindwardWalls), |u| as much is lifted, hops reach u L, and of what arrives
/// at least 1 − |u| stays. Where it also blows aside there, with v, hops reach √(u² + v²) L that
/// way, f (1 − r) max(u, 0) + √(min(u, 0)² + v²) as much is lifted, since neither the linear shear
/// stress nor the wind shadow knows the eddy, and at least max(r, 1 − √(u² + v²)) (1 − |v|) stays.
///
/// A bent wind turns hops only: shadows, the shear stress and what comes in over open edges are of
/// the wind as it blows over flat ground.
///
/// Amounts are whole numbers; what division leaves over goes to the middle cell, so nothing is
/// lost and no result depends on the order of the cells. Beyond open edges lies flat ground that
/// drifts at the share `influx` of saturation.
class ContinuousTransport {
  public:
    ContinuousTransport(const DunesParameters& parameters, const DuneGround& ground,
                        double time_step, WorkerPool& pool);

    void step(DuneBed& bed, const WindOverBed& wind);

    /// What came down in each cell in the last step, where rock is worn, and the part of it that
    /// ended a hop there.
    [[nodiscard]] const FixedPointGrid& landed() const { return landed_; }
    [[nodiscard]] double ended() const { return hops_.ends; }

  private:
    /// e0, units
    [[nodiscard]] double layer_of(const BlowingWind& wind) const;
    void lift(DuneBed& bed, const WindOverBed& wind, double layer, int y) const;
    void deposit(FixedPointGrid& on, DuneBed& bed, const WindOverBed& wind, int y);
    void drift_down(const DuneBed& bed, const WindOverBed& wind, int y);

    DunesParameters parameters_;
    DuneGround ground_;
    double drift_;         ///< saturated, of a step of a wind of strength 1, units times metres
    SaturationHops hops_;  ///< of the step
    WorkerPool& pool_;
    double drift_x_;  ///< c q0 Δt / dx² of a wind of strength 1
    double drift_y_;
    Saltation saltation_;
    FixedPointGrid landed_;  ///< in all moves of the step
    FixedPointGrid after_;   ///< the surface after the step
};

}  // namespace fumon
