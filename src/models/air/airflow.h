#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "models/air/air_plane.h"
#include "models/air/air_scheme.h"
#include "models/air/airflow_parameters.h"
#include "models/air/grain_flight.h"
#include "models/shared/model.h"
#include "numerics/stress_fit.h"

namespace fumon {

/// Laminar air between a fixed bed h(x) and a lid that moves at u0 (Terada 2025, sections 2 and 3):
///
///     ∇·v = 0,   ∂v/∂t + (v·∇)v = −∇p/ρ + ν ∇²v          (eqs. 6, 7)
///
/// in the plane (x, z), periodic in x, no slip at bed and lid; from Couette flow above the bed's
/// highest point (eq. 8). In metres and seconds; see air_projection.h and fitted_airflow.h for the
/// schemes. A step is Δt.
///
/// The thesis's step counts (its eq. 36) are no steady state yet: the stress on its tables' beds
/// still rises by 24 to 40 %. `until_steady` goes on to the true one and stops there.
///
/// A staircase's stress is within 2 % of a smooth bed's in the mean, 6 % in the amplitude and 5 %
/// in the phase on the thesis's table C1; the fitted grid's within 2 % on 100 × 30 nodes.
class Airflow : public Model {
  public:
    static constexpr std::string_view model_name = "airflow";
    static constexpr Landform landform = Landform::air;

    /// Throws KeyError as make_air_plane does, for a time step in which the lid moves a cell or
    /// more, one beyond u0 Δt/Δr + 4ν Δt/Δr² = 1 (staircase) or u0² Δt/ν = 2 (boundary-fitted), and
    /// for waves too many for the columns; for the grains as check(FlightParameters) does.
    Airflow(const AirflowParameters& parameters, const ModelSetup& setup);

    [[nodiscard]] std::string_view name() const override { return model_name; }

    /// Throws Error where a velocity is no longer finite.
    void step() override;
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    /// Seconds; a flow held as steady does not age.
    [[nodiscard]] double time() const override {
        return static_cast<double>(flow_steps_) * parameters_.time_step;
    }
    [[nodiscard]] std::string_view time_unit() const override { return "s"; }

    /// The bed (m), and as section "velocity_x", "velocity_z" (m/s), "pressure" (Pa), "vorticity"
    /// (1/s) and the curves "bed_shear_stress" (Pa), "bed_height" (m). Numbers: "lid_speed",
    /// "bed_waves", "reynolds" u0 W/ν, the fit "stress_amplitude", "stress_phase", "stress_mean",
    /// "largest_divergence", "stress_change" (see model.steady_tolerance), "steady" (0 or 1) and
    /// "steady_time", when it became so. With flights (model.flights) also what add_flights adds.
    [[nodiscard]] Snapshot snapshot() const override;

    /// When the flow became steady (model.steady_tolerance), s; nothing before.
    [[nodiscard]] std::optional<double> steady_since() const {
        return steady_ ? std::optional(steady_time_) : std::nullopt;
    }

    [[nodiscard]] const AirflowParameters& parameters() const { return parameters_; }

    /// Flies a grain from every column at each of model.launch_angles, angle by angle, through the
    /// air as it is now; `hops` flights in succession each. Throws as GrainFlights does.
    [[nodiscard]] std::vector<Flight> fly_grains(int hops) const;

    /// The scheme's fields, column by column. The spans hold until the next step.
    [[nodiscard]] std::vector<StateField> state() const override;

    void serialise(StateArchive& archive) override;

  private:
    void watch_stress();
    [[nodiscard]] StressFit fitted_stress() const;
    [[nodiscard]] std::shared_ptr<SnapshotSection> flow_section() const;
    [[nodiscard]] Air air() const { return {parameters_.density, parameters_.viscosity}; }

    AirflowParameters parameters_;
    WorkerPool* pool_;
    AirPlane plane_;
    std::unique_ptr<AirScheme> flow_;
    double decay_time_;  ///< (H − mean h)²/(π²ν), s
    std::int64_t watch_every_;
    StressFit last_fit_;
    double stress_change_ = 1.0;
    bool steady_ = false;
    double steady_time_ = 0.0;
    std::int64_t steps_ = 0;
    std::int64_t flow_steps_ = 0;
};

}  // namespace fumon
