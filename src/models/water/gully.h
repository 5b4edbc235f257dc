#pragma once

#include <array>
#include <memory>

#include "models/shared/model.h"
#include "models/water/gauges.h"
#include "models/water/gully_parameters.h"
#include "models/water/gully_setup.h"
#include "models/water/infiltration.h"
#include "models/water/rain.h"
#include "models/water/sediment.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// Gullies (Saeki & Okamura 2007): shallow water that runs down a tilted plane or over a terrain
/// and changes its bed.
///
///     Du/Dt = −g ∂(h+z)/∂x − τx/(ρh)     ∂h/∂t + ∇·(h u) = rain       τ = ρ C_f |u| u
///     Dv/Dt = −g ∂(h+z)/∂y − g·slope − τy/(ρh)                        (ShallowWaterScheme)
///     ∂z/∂t = transport by q_s + D ∇²z                   (Sediment, or SedimentLoads)
///
/// h depth (m), (u, v) depth-averaged velocity (m/s), z bed (m, departure from the mean plane,
/// which descends toward −y). A step is model.time_step seconds, cut into sub-steps; in each the
/// water goes first, then the bed. Valid for depths small against the lengths along the bed.
///
/// What the paper leaves open: "K_t = 0" would stop all transport and is read as K_t = 1, p = 1;
/// the signs of eq. (12) are a choice (model.transport), since with −∇·q_s no channels grow;
/// eq. (9) halves eq. (6)'s friction (model.friction).
class Gully : public Model {
  public:
    static constexpr std::string_view model_name = "gully";
    static constexpr Landform landform = Landform::water;

    /// Throws KeyError where parameters and bed do not go together (start_of_gully,
    /// make_water_scheme) or a fixed time step is beyond Courant number 1.
    Gully(const GullyParameters& parameters, ModelSetup setup);

    [[nodiscard]] std::string_view name() const override { return model_name; }
    /// Throws Error that names cell, time and quantity where a value stops being one, or the flow
    /// needs thousands of sub-steps.
    void step() override;
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] double time() const override {
        return static_cast<double>(steps_) * parameters_.time_step;
    }
    [[nodiscard]] std::string_view time_unit() const override { return "s"; }
    [[nodiscard]] Snapshot snapshot() const override;
    /// On a terrain file: where the bed has changed by over a metre, faster than a metre an hour;
    /// and where over 2 % of its change is furrows of two cells (two_cell_pattern()), deeper
    /// than 5 mm.
    [[nodiscard]] std::string plausibility_warning() const override;
    [[nodiscard]] std::vector<StateField> state() const override;
    void serialise(StateArchive& archive) override;

  private:
    [[nodiscard]] std::string furrow_warning(double largest) const;
    Gully(const GullyStart& start, const WorldScale& scale, WorkerPool& pool);

    void sub_step(double dt, double& elapsed);
    [[nodiscard]] double sub_step_size(double remaining, double elapsed) const;
    [[nodiscard]] double water_volume() const;
    [[nodiscard]] double bed_volume() const;
    [[nodiscard]] double sediment_removed() const;
    [[nodiscard]] std::vector<SnapshotNumber> budgets() const;
    void add_loads(Snapshot& snapshot) const;
    /// Steps before the bed moves.
    [[nodiscard]] std::int64_t resting_steps() const;
    [[nodiscard]] bool transports_loads() const { return loads_ && steps_ >= resting_steps(); }

    GullyParameters parameters_;
    WaterDomain domain_;
    WorldScale scale_;
    WorkerPool& pool_;
    Grid bed_;
    bool on_terrain_;  ///< the bed is a terrain file's
    Grid first_bed_;   ///< at the start, m; empty but on terrain and under loads
    Water water_;
    std::unique_ptr<ShallowWaterScheme> scheme_;
    double step_at_courant_one_;  ///< of the water as it is, s
    Sediment sediment_;
    std::unique_ptr<SedimentLoads> loads_;  ///< or null
    FaceFlows flows_;                       ///< of the water, where it carries loads
    Infiltration infiltration_;
    Gauges gauges_;
    double cell_area_;
    double wet_area_;  ///< of all cells with data, m²
    double first_water_;
    double first_bed_volume_;
    std::shared_ptr<Rain> rain_;        ///< snapshots ask it too
    CompensatedSum fallen_;             ///< rain since the start, m³
    std::array<double, 3> counters_{};  ///< rain, left, sediment removed: m³
    std::int64_t steps_ = 0;
    std::int64_t substeps_ = 0;
};

/// The same over a bed that is fixed, level, walled in and dry unless a scene says otherwise:
/// breaking dams, floods, lakes, rain.
class WaterModel : public Gully {
  public:
    static constexpr std::string_view model_name = "water";

    using Gully::Gully;
    [[nodiscard]] std::string_view name() const override { return model_name; }
};

}  // namespace fumon
