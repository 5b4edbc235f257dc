#pragma once

#include <array>

#include "models/shared/padded_grid.h"
#include "models/water/cip_rows.h"
#include "models/water/depth_flux.h"
#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// Shallow water on a periodic plane by the CIP method, as Saeki & Okamura (2007) compute it:
/// values and gradients of the velocities are advected together (cip::advect_row), forces follow
/// (eqs. 10, 11). The depth goes
///
///  * by default with conserved fluxes of the new velocities (DepthFlux): water is kept to rounding
///    and never negative;
///  * as published, with CIP too and −h ∇·u after it: .01 % of the water is lost at slope .04, a
///    third at slope .1, and depths can become negative.
///
/// Valid for sub-steps below Courant number 1; shocks of deep water over dry ground are beyond it.
class CipScheme : public ShallowWaterScheme {
  public:
    CipScheme(const GullyParameters& parameters, const WaterDomain& domain, const Water& start,
              WorkerPool& pool);

    [[nodiscard]] double step_at_courant_one(const Water& water) const override;
    /// `water` must be what the last call left, or what the scheme was built on.
    void advance(Water& water, const Grid& bed, double dt, double rain) override;
    [[nodiscard]] std::vector<StateField> state() const override;
    void carry(StateCarrier& carrier) override;

  private:
    /// A carried quantity: value and per-cell gradient before and after a sub-step, and what the
    /// value gained beside advection.
    struct Carried {
        Carried() = default;
        Carried(int nx, int ny)
            : value(nx, ny),
              gradient_x(nx, ny),
              gradient_y(nx, ny),
              next(nx, ny),
              next_x(nx, ny),
              next_y(nx, ny),
              gained(nx, ny) {}
        PaddedGrid value, gradient_x, gradient_y;
        PaddedGrid next, next_x, next_y;
        PaddedGrid gained;
    };

    void start_from(const Grid& values, Carried& carried) const;
    void advect_and_accelerate(const cip::SubStep& step, Water& water, const Grid& bed);
    void thin_as_published(const cip::SubStep& step, double rain);
    void turn_velocity_gradients(const cip::SubStep& step, int y);
    void turn_gradient(const cip::SubStep& step, Carried& carried, int y) const;
    [[nodiscard]] cip::Stencil around(const PaddedGrid& grid, int y) const;

    bool as_published_;
    bool steep_;
    int nx_;
    int ny_;
    WaterDomain domain_;
    double gravity_;
    double friction_;
    WorkerPool& pool_;
    Carried u_;
    Carried v_;
    Carried depth_;
    DepthFlux flux_;
};

}  // namespace fumon
