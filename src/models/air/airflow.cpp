#include "models/air/airflow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/state_archive.h"
#include "models/air/air_projection.h"
#include "models/air/fitted_airflow.h"
#include "models/air/section_flights.h"

namespace fumon {

namespace {

/// Up to which the scheme's explicit differences are stable, s: u0 Δt/Δr + 4 ν Δt/Δr² = 1 on the
/// staircase; on the fitted grid central advection must not outdo diffusion.
double longest_step(const AirPlane& plane, const AirflowParameters& parameters) {
    if (parameters.scheme == AirSchemeKind::staircase)
        return plane.spacing * plane.spacing /
               (parameters.lid_speed * plane.spacing + 4.0 * parameters.viscosity);
    return 2.0 * parameters.viscosity / (parameters.lid_speed * parameters.lid_speed);
}

std::unique_ptr<AirScheme> make_scheme(const AirPlane& plane, const AirflowParameters& parameters,
                                       WorkerPool& pool) {
    if (parameters.scheme == AirSchemeKind::staircase)
        return std::make_unique<AirProjection>(plane, parameters, pool);
    return std::make_unique<FittedAirflow>(plane, parameters);
}

AirPlane checked_plane(const AirflowParameters& parameters, const ModelSetup& setup) {
    check(parameters.flight);
    AirPlane plane = make_air_plane(parameters, setup);
    const double courant = parameters.lid_speed * parameters.time_step / plane.spacing;
    if (courant >= 1.0) {
        throw KeyError("model.time_step",
                       fmt::format("in {:.4g} s the lid moves {:.3g} cells at {:.4g} m/s; take "
                                   "less than {:.4g} s",
                                   parameters.time_step, courant, parameters.lid_speed,
                                   plane.spacing / parameters.lid_speed));
    }
    const double longest = longest_step(plane, parameters);
    if (parameters.time_step > longest) {
        throw KeyError("model.time_step",
                       fmt::format("{:.4g} s is too long at {:.4g} m/s for a viscosity of {:.4g} "
                                   "m^2/s on cells of {:.4g} m; take {:.4g} s or less",
                                   parameters.time_step, parameters.lid_speed, parameters.viscosity,
                                   plane.spacing, longest));
    }
    if (2 * parameters.bed_waves >= plane.nx) {
        throw KeyError("model.bed_waves", fmt::format("{} waves do not fit {} columns; take fewer "
                                                      "than half of them",
                                                      parameters.bed_waves, plane.nx));
    }
    return plane;
}

double decay_time(const AirPlane& plane, double viscosity) {
    const double mean_height =
        std::accumulate(plane.height.begin(), plane.height.end(), 0.0) / plane.nx;
    const double gap = plane.nz * plane.spacing - mean_height;
    return gap * gap / (std::numbers::pi * std::numbers::pi * viscosity);
}

/// ∂u/∂z − ∂w/∂x by central differences at an air node, 1/s.
double vorticity(const AirPlane& plane, const std::vector<double>& u, const std::vector<double>& w,
                 int i, int k) {
    return (u[plane.at(i, k + 1)] - u[plane.at(i, k - 1)] - w[plane.at(plane.right(i), k)] +
            w[plane.at(plane.left(i), k)]) /
           (2.0 * plane.spacing);
}

}  // namespace

Airflow::Airflow(const AirflowParameters& parameters, const ModelSetup& setup)
    : parameters_(parameters),
      pool_(&setup.pool),
      plane_(checked_plane(parameters, setup)),
      flow_(make_scheme(plane_, parameters, setup.pool)),
      decay_time_(decay_time(plane_, parameters.viscosity)),
      last_fit_(fitted_stress()) {
    constexpr double watches_per_decay = 50.0;
    watch_every_ = std::max<std::int64_t>(
        1, std::llround(decay_time_ / parameters.time_step / watches_per_decay));
}

void Airflow::step() {
    const bool rests = steady_ && parameters_.until_steady;
    if (!rests) flow_->step();
    ++steps_;
    if (rests) return;
    ++flow_steps_;
    if (flow_steps_ % watch_every_ == 0) watch_stress();
}

void Airflow::watch_stress() {
    const StressFit fit = fitted_stress();
    const double changed = std::max(std::abs(fit.mean - last_fit_.mean),
                                    std::abs(fit.amplitude - last_fit_.amplitude));
    const double elapsed = static_cast<double>(watch_every_) * parameters_.time_step;
    const double size = std::abs(fit.mean);
    stress_change_ = size > 0.0 ? changed / size * (decay_time_ / elapsed) : 0.0;
    last_fit_ = fit;
    if (steady_ || stress_change_ >= parameters_.steady_tolerance) return;
    steady_ = true;
    steady_time_ = time();
}

StressFit Airflow::fitted_stress() const {
    return fit_stress(flow_->bed_stress(), static_cast<int>(parameters_.bed_waves));
}

std::shared_ptr<SnapshotSection> Airflow::flow_section() const {
    auto section = std::make_shared<SnapshotSection>();
    section->dx = plane_.spacing;
    section->dz = plane_.spacing;
    const AirFields now = flow_->fields();
    const Grid empty(plane_.nx, plane_.nz);
    section->fields = {{"velocity_x", "velocity of the air along x", "m/s", empty},
                       {"velocity_z", "velocity of the air upward", "m/s", empty},
                       {"pressure", "pressure of the air, 0 in its mean", "Pa", empty},
                       {"vorticity", "du/dz - dw/dx of the air", "1/s", empty}};
    const auto for_each_air_node = [&](auto body) {
        for (int i = 0; i < plane_.nx; ++i) {
            for (int k = plane_.under_bed[static_cast<std::size_t>(i)] + 1; k < plane_.nz; ++k)
                body(i, k);
        }
    };
    for_each_air_node([&](int i, int k) {
        section->fields[0].values(i, k) = now.u[plane_.at(i, k)];
        section->fields[1].values(i, k) = now.w[plane_.at(i, k)];
        section->fields[2].values(i, k) = now.pressure[plane_.at(i, k)];
        section->fields[3].values(i, k) = vorticity(plane_, now.u, now.w, i, k);
    });
    // Known up to a constant only.
    double sum = 0.0;
    std::int64_t nodes = 0;
    for_each_air_node([&](int i, int k) {
        sum += section->fields[2].values(i, k);
        ++nodes;
    });
    for_each_air_node(
        [&](int i, int k) { section->fields[2].values(i, k) -= sum / static_cast<double>(nodes); });
    section->curves = {{"bed_shear_stress", "shear stress on the bed", "Pa", flow_->bed_stress()},
                       {"bed_height", "height of the bed", "m", plane_.height}};
    return section;
}

std::vector<Flight> Airflow::fly_grains(int hops) const {
    const GrainFlights grains(*flow_section(), parameters_.flight, air(), *pool_);
    return grains.in_succession(grains.every_column(parameters_.flight.launch_angles), hops);
}

Snapshot Airflow::snapshot() const {
    Grid bed(plane_.nx, 1);
    std::copy(plane_.height.begin(), plane_.height.end(), bed.values().begin());
    Snapshot snapshot{steps_, time(), std::string(time_unit()), std::move(bed), {}, {}};
    snapshot.landform = landform;
    snapshot.scale = {plane_.spacing, plane_.spacing, 1.0, true};
    snapshot.highest_expected = plane_.largest_height;
    snapshot.periodic = true;

    const StressFit fit = fitted_stress();
    const double width = plane_.nx * plane_.spacing;
    snapshot.numbers = {{"lid_speed", "m/s", parameters_.lid_speed},
                        {"bed_waves", "1", static_cast<double>(parameters_.bed_waves)},
                        {"reynolds", "1", parameters_.lid_speed * width / parameters_.viscosity},
                        {"stress_amplitude", "Pa", fit.amplitude},
                        {"stress_phase", "rad", fit.phase},
                        {"stress_mean", "Pa", fit.mean},
                        {"largest_divergence", "1/s", flow_->largest_divergence()},
                        {"stress_change", "1", stress_change_},
                        {"steady", "1", steady_ ? 1.0 : 0.0},
                        {"steady_time", "s", steady_time_}};
    const auto section = flow_section();
    if (parameters_.flight.flights) {
        const auto flown = add_flights(*section, parameters_.flight, air(), *pool_);
        snapshot.numbers.insert(snapshot.numbers.end(), flown.begin(), flown.end());
    }
    snapshot.section = section;
    return snapshot;
}

std::vector<StateField> Airflow::state() const {
    return flow_->state();
}

void Airflow::serialise(StateArchive& archive) {
    archive.count("steps", steps_);
    archive.count("aged_steps", flow_steps_);
    flow_->serialise(archive);
    archive.value("last_stress_mean", last_fit_.mean);
    archive.value("last_stress_amplitude", last_fit_.amplitude);
    archive.value("stress_change", stress_change_);
    archive.value("steady", steady_);
    archive.value("steady_time", steady_time_);
}

}  // namespace fumon
