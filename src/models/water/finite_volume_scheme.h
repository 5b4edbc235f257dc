#pragma once

#include <vector>

#include "base/state_carrier.h"
#include "models/water/finite_volume_strip.h"
#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// Shallow water by a well-balanced finite-volume scheme of second order in space and time, for wet
/// and dry ground:
///
///     ∂h/∂t + ∂(hu)/∂x + ∂(hv)/∂y = rain
///     ∂(hu)/∂t + ∂(hu² + g h²/2)/∂x + ∂(huv)/∂y = −g h ∂z/∂x − C_f |u| u
///     ∂(hv)/∂t + ∂(huv)/∂x + ∂(hv² + g h²/2)/∂y = −g h ∂z/∂y − g h·slope − C_f |u| v
///
/// Limited linear reconstruction of depth, surface and velocities (MUSCL), hydrostatic
/// reconstruction of the bed's steps (Audusse et al. 2004; Chen & Noelle 2017), HLLC fluxes, Heun's
/// two stages with friction implicit in each. Water at rest stays at rest, depth never becomes
/// negative (outward fluxes are cut to the water that is there) and no water is lost; a uniform
/// film at V = √(g h·slope/C_f) stays uniform. Water thinner than 10⁻⁹ m does not move.
///
/// Edges: periodic; wall, a mirror; open, and likewise cells without data: a dry step of equal
/// height over which water falls, so that it leaves freely and none comes in.
class FiniteVolumeScheme : public ShallowWaterScheme {
  public:
    FiniteVolumeScheme(const GullyParameters& parameters, const WaterDomain& domain,
                       WorkerPool& pool);

    [[nodiscard]] double step_at_courant_one(const Water& water) const override;
    double advance(Water& water, const Grid& bed, double dt, double rain) override;
    [[nodiscard]] double left() const override { return left_; }
    void carry(StateCarrier& carrier) override { carrier.value("left_volume", left_); }

  private:
    struct Stage;

    /// A face of a cell through which water leaves the domain.
    struct Outlet {
        int x = 0;
        finite_volume::Side side = finite_volume::Side::west;
    };

    void find_outlets();
    void run(const Stage& stage);
    void advance_block(const Stage& stage, finite_volume::Strip& strip, int first_row,
                       int last_row);
    void load_row(const Stage& stage, finite_volume::Strip& strip, int y) const;
    void count_left(const finite_volume::Strip& strip, int y);
    void rate_row(const Water& water, const finite_volume::Strip& strip, int y);

    WaterDomain domain_;
    double gravity_;
    double friction_;
    WorkerPool& pool_;
    int nx_ = 0;
    int ny_ = 0;
    Water between_;                             // after the first stage
    std::vector<std::vector<Outlet>> outlets_;  // of each row
    std::vector<double> row_left_;              // of a stage, m³/s
    std::vector<double> row_rates_;             // of the water that the last step left, 1/s
    double left_ = 0.0;
    std::vector<finite_volume::Strip> strips_;  // one a thread
};

}  // namespace fumon
