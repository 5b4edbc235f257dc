#pragma once

#include <vector>

#include "models/shared/padded_grid.h"
#include "models/water/cip_strip.h"
#include "models/water/depth_flux.h"
#include "models/water/kernels/cip_vectors.h"
#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// Shallow water on a periodic plane by the CIP method, as Saeki & Okamura (2007) compute it:
/// values and gradients of the velocities are advected together (cip::advect_velocities), forces
/// follow (eqs. 10, 11). The depth goes
///
///  * by default with conserved fluxes of the new velocities (cip::through_faces): water is kept to
///    rounding and never negative;
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
    double advance(Water& water, const Grid& bed, double dt, double rain) override;
    /// As published, where no water passes faces: h u of the cells beside them, in the mean.
    void watch(WatchedFaces& faces) override { watched_ = &faces; }
    [[nodiscard]] std::vector<StateField> state() const override;
    void serialise(StateArchive& archive) override;

  private:
    /// Of a carried quantity per cell, before and after a sub-step.
    struct Gradient {
        Gradient() = default;
        Gradient(int nx, int ny) : x(nx, ny), y(nx, ny), next_x(nx, ny), next_y(nx, ny) {}
        PaddedGrid x, y;
        PaddedGrid next_x, next_y;
    };

    /// A block of columns and the rows of it that a thread takes.
    struct Block {
        int first_x;
        int count;
        int first_y;
        int last_y;  ///< past it
    };

    void start_from(const Grid& values, Gradient& gradient) const;
    void advance_block(const cip::SubStep& step, const Water& water, const Grid& bed, double rain,
                       const Block& block, cip::Strip& strip);
    void load_row(const Water& water, const Grid& bed, const Block& block, int y,
                  cip::Strip& strip) const;
    void accelerate(const cip::SubStep& step, const Block& block, int y, cip::Strip& strip);
    void turn_gradients(const cip::SubStep& step, const Block& block, int y, cip::Strip& strip);
    void transport_depth(const cip::SubStep& step, double rain, const Block& block, int y,
                         cip::Strip& strip);
    void advect_depth(const cip::SubStep& step, const Block& block, int y, cip::Strip& strip);
    void thin_as_published(const cip::SubStep& step, const Water& before, double rain);
    void count_watched(const Block& block, int y, cip::Strip& strip) const;
    void count_shared(const PassedDepth& passed) const;
    void count_as_published(const Water& water, double dt) const;
    [[nodiscard]] int wrapped(int y) const { return ((y % ny_) + ny_) % ny_; }
    [[nodiscard]] cip::Stencil around(const PaddedGrid& grid, int y, int first_x = 0) const;
    [[nodiscard]] cip::SubStep sub_step(double dt) const;

    bool as_published_;
    bool steep_;
    int nx_;
    int ny_;
    WaterDomain domain_;
    double gravity_;
    double friction_;
    WorkerPool& pool_;
    WatchedFaces* watched_ = nullptr;  ///< by gauges
    Gradient of_u_;
    Gradient of_v_;
    Gradient of_depth_;  ///< as published only
    PaddedGrid gained_depth_;
    Water next_;
    std::vector<cip::Strip> strips_;  // one a thread
    std::vector<char> overdrawn_;     ///< rows where more would leave a cell than it has
    std::vector<double> rates_;       ///< of rows, as cip::fastest gives them
};

}  // namespace fumon
