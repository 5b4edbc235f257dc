#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/compensated_sum.h"
#include "base/grid.h"
#include "base/state_archive.h"
#include "models/sediment/bank_collapse.h"
#include "models/sediment/face_flows.h"
#include "models/sediment/load_ground.h"
#include "models/sediment/load_parameters.h"
#include "models/sediment/load_vectors.h"
#include "models/shared/model.h"
#include "models/shared/padded_grid.h"

namespace fumon {

class WorkerPool;

/// The water of a sub-step as it has become; nx × ny each.
struct LoadWater {
    const Grid& depth;  ///< h, m
    const Grid& u;      ///< m/s, eastward
    const Grid& v;      ///< m/s, northward
};

/// Bed load and suspended load, and the bed that they come from and go to (Exner 1925):
///
///     (1 − φ) ∂z/∂t = f (D − E − ∇·q_b)        ∂(hC)/∂t + ∇·(h u C) = E − D
///     q_b = q (u/|u| − (r/√θ) ∇z)              E = (M/ρ_s) (τ/τ_e − 1), 0 where τ < τ_e
///     D = α w_s C                              θ = τ / ((ρ_s − ρ) g d)
///
/// with q = √((s−1) g d³) times 8 (θ − θ_c)^{3/2} (Meyer-Peter & Müller 1948) or
/// 17 θ^{3/2} (1 − θ_c/θ)(1 − √(θ_c/θ)) (Ashida & Michiue 1972, whose effective stress is here the
/// whole one). θ_c, on a level bed θ_c0, is θ_c0 (1 + u/|u| · ∇z / tan(angle of repose)) (Fredsøe &
/// Deigaard 1992, to first order); the turning down the slope is that of Ikeda (1982), the mean
/// slope is in ∇z. E is Partheniades' (1965). f is the morphological factor: the water's load
/// stands for f times as much.
///
/// The load goes through the faces of the cells with the very water that went there, at the
/// concentration of the cell upstream, in the two stages of the water's scheme: C keeps within
/// those around it. Settling is implicit; what is in water thinner than a thousandth of a
/// millimetre lies down, and so do loads below loads::least_load. Bed load through a face comes
/// from the cell upstream; down the slope it is the mean of both. Explicit: sub-steps have to be
/// shorter than half of 1 / bed_rate().
///
/// Beyond edges: water brings grains at the inflow's concentration, and as much bed load as the
/// cell at the edge carries, so that the bed there stays; what goes out with water is gone.
/// Nothing passes where no water does.
///
/// bed + suspended + gone − come is constant but for rounding, counted with
/// f / (1 − φ) times the volumes of grains.
class SedimentLoads {
  public:
    SedimentLoads(const LoadParameters& parameters, LoadGround ground, WorkerPool& pool);

    /// Before the water's sub-step, with its depth then.
    void begin(const Grid& depth);
    /// After it: carries the load, and changes the bed (m, departures from the mean plane) over
    /// `dt` seconds.
    void advance(Grid& bed, const LoadWater& water, const FaceFlows& flows, double dt);
    /// Lets banks slide that are steeper than the angle of repose.
    void fail_banks(Grid& bed) {
        if (banks_) banks_->fail(bed);
    }

    /// How fast the bed changes against the water over it, 1/s, of the flow that the last advance
    /// saw.
    [[nodiscard]] double bed_rate() const { return bed_rate_; }

    /// Heights of bed that a height of grains makes in a run's time: f / (1 − φ).
    [[nodiscard]] double bed_factor() const { return bed_factor_; }
    /// Volumes of grains, m³: in the water, and through the edges since the start.
    [[nodiscard]] double suspended() const;
    [[nodiscard]] double left() const { return left_.value(); }
    [[nodiscard]] double entered() const { return entered_.value(); }
    /// Volume of grains over that of the water.
    [[nodiscard]] Grid concentration(const Grid& depth) const;

    [[nodiscard]] std::vector<StateField> state() const;
    void serialise(StateArchive& archive);

  private:
    /// A face between a cell of the domain and what is outside.
    struct OuterFace {
        int x = 0;  ///< of the cell
        int y = 0;
        bool along_x = true;  ///< the face's normal
        bool low = true;      ///< it lies west or south of the cell
        [[nodiscard]] int face_x() const { return along_x && !low ? x + 1 : x; }
        [[nodiscard]] int face_y() const { return !along_x && !low ? y + 1 : y; }
    };

    /// What a thread holds while it works on rows.
    struct Scratch {
        std::vector<double> entrainment;  ///< of a row, where no others need it
        std::vector<double> bed_rates;
        std::vector<double> nothing;  ///< for a load, where nothing is suspended
        std::vector<double> kept;     ///< the bed of a row with cells without data
    };

    void find_outer_faces();
    template <class Body>
    void over_rows(const Body& body);
    void fill_ghost_cells(PaddedGrid& field, bool extrapolated, double beyond) const;
    void copy_bed(const Grid& bed);
    void advect_load_row(int stage, const FaceFlows& flows, double dt, int y);
    void advect_first_stage(const FaceFlows& flows, double dt);
    [[nodiscard]] const double* friction_of(int y) const;
    [[nodiscard]] double* entrainment_of(int y, Scratch& scratch);
    void pick_up_row(const LoadWater& water, int y, Scratch& scratch);
    void find_faces(const FaceFlows& flows);
    void hold_above_base(const Grid& bed, double dt);
    void count_outer_faces(const FaceFlows& flows, double dt);
    void settle_row(Grid& bed, const LoadWater& water, double dt, int y, Scratch& scratch);
    /// Of what lies above the base level, what may leave one way, of grains: 1/s.
    [[nodiscard]] double above_base_share(double dt) const { return 0.5 / (bed_factor_ * dt); }

    [[nodiscard]] double* row(PaddedGrid& field, int y) const { return field.row(y + 1); }

    LoadGround ground_;
    WorkerPool& pool_;
    loads::PickUpLaw law_;
    double settling_;  ///< α w_s, m/s
    double inflow_;    ///< concentration
    double bed_factor_;
    bool suspends_;
    Grid floor_;  ///< of erosion, as a departure from the mean plane; empty: none
    std::unique_ptr<BankCollapse> banks_;
    std::vector<OuterFace> outer_faces_;
    Grid load_;  ///< hC, m; empty where nothing is suspended
    Grid between_;
    // With a row beyond either end, and cells beyond the rows' ends.
    PaddedGrid before_;  ///< concentrations at the start of the sub-step and between its stages
    PaddedGrid middle_;
    PaddedGrid bed_;
    PaddedGrid along_x_;
    PaddedGrid along_y_;
    PaddedGrid down_slope_;
    Grid entrainment_;  ///< m/s; empty without bed load
    Grid east_;         ///< bed load through the faces, as in FaceFlows, m²/s
    Grid north_;
    Grid shares_;                       ///< of its bed load that a cell gives, for the base level
    std::vector<double> friction_row_;  // where it is even
    std::vector<double> row_bed_rates_;
    double bed_rate_ = 0.0;
    CompensatedSum left_;
    CompensatedSum entered_;
};

}  // namespace fumon
