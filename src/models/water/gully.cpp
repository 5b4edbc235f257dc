#include "models/water/gully.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/state_carrier.h"
#include "base/worker_pool.h"
#include "models/water/water_check.h"

namespace fumon {

namespace {

constexpr int most_substeps = 5000;
constexpr double metres_per_second = 1.0 / 3.6e6;  // of a millimetre per hour

template <class Value>
double sum_of(const Grid& grid, const Mask& nodata, Value value) {
    CompensatedSum sum;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        if (nodata.empty() || nodata.values()[cell] == 0) sum.add(value(grid.values()[cell]));
    }
    return sum.value();
}

double share(double error, std::initializer_list<double> amounts) {
    double largest = 0.0;
    for (const double amount : amounts) largest = std::max(largest, std::fabs(amount));
    return largest > 0.0 ? error / largest : 0.0;
}

void check_time_step(const GullyParameters& parameters, double step_at_one) {
    if (parameters.substeps != Substeps::fixed || parameters.time_step <= step_at_one) return;
    throw KeyError(
        "model.time_step",
        fmt::format("a fixed model.time_step of {:.4g} s has Courant number {:.3g} at "
                    "the start; take at most {:.3g} s or model.substeps = \"adaptive\"",
                    parameters.time_step, parameters.time_step / step_at_one, step_at_one));
}

}  // namespace

Gully::Gully(const GullyParameters& parameters, ModelSetup setup)
    : Gully(start_of_gully(parameters, setup), setup.scale, setup.pool) {}

Gully::Gully(const GullyStart& start, const WorldScale& scale, WorkerPool& pool)
    : parameters_(start.parameters),
      domain_(start.domain),
      scale_(scale),
      pool_(pool),
      bed_(start.bed),
      water_(start.water),
      scheme_(make_water_scheme(start, pool)),
      sediment_(parameters_, domain_, bed_.nx(), bed_.ny(), pool),
      cell_area_(domain_.dx * domain_.dy),
      wet_area_(cell_area_ * sum_of(bed_, domain_.nodata, [](double) { return 1.0; })),
      first_water_(water_volume()),
      first_bed_(bed_volume()) {
    check_time_step(parameters_, scheme_->step_at_courant_one(water_));
}

void Gully::step() {
    double remaining = parameters_.time_step;
    double elapsed = time();
    substeps_ = 0;
    while (remaining > 0.0) {
        const double dt = sub_step_size(remaining, elapsed);
        sub_step(dt, elapsed);
        remaining = dt == remaining ? 0.0 : remaining - dt;
        if (++substeps_ > most_substeps) {
            refuse_speed(water_, elapsed,
                         fmt::format("a step takes more than {} sub-steps", most_substeps));
        }
    }
    ++steps_;
    check_water(water_, bed_, time(), pool_);
    counters_ = {rain_.value(), scheme_->left(), sediment_.removed()};
}

/// An equal share of what remains of the step, as large as the Courant number allows.
double Gully::sub_step_size(double remaining, double elapsed) const {
    if (parameters_.substeps == Substeps::fixed) return remaining;
    const double limit = parameters_.courant_number * scheme_->step_at_courant_one(water_);
    const double pieces = std::ceil(remaining / limit * (1.0 - 1e-12));
    if (pieces <= 1.0) return remaining;
    if (!(pieces <= most_substeps)) {
        check_water(water_, bed_, elapsed, pool_);
        refuse_speed(water_, elapsed, fmt::format("a sub-step would be {:.3g} s", limit));
    }
    return remaining / pieces;
}

void Gully::sub_step(double dt, double& elapsed) {
    const double until = parameters_.rain_until > 0.0 ? parameters_.rain_until : elapsed + dt;
    const double raining = std::clamp(until - elapsed, 0.0, dt) / dt;
    const double rain = raining * parameters_.rain * metres_per_second;
    scheme_->advance(water_, bed_, dt, rain);
    rain_.add(rain * dt * wet_area_);
    sediment_.advance(bed_, water_, dt);
    elapsed += dt;
}

double Gully::water_volume() const {
    return cell_area_ * sum_of(water_.depth, domain_.nodata, [](double h) { return h; });
}

double Gully::bed_volume() const {
    return cell_area_ * sum_of(bed_, domain_.nodata, [](double z) { return z; });
}

std::vector<SnapshotNumber> Gully::budgets() const {
    const double water = water_volume();
    const double rain = rain_.value();
    const double left = scheme_->left();
    const double sediment = bed_volume() - first_bed_;
    const double removed = sediment_.removed();
    const double in_relief =
        cell_area_ * sum_of(bed_, domain_.nodata, [](double z) { return std::fabs(z); });
    return {
        {"mean_slope", "m/m", domain_.slope},
        {"gravity", "m/s2", parameters_.gravity},
        {"water_volume", "m3", water},
        {"rain_volume", "m3", rain},
        {"left_volume", "m3", left},
        {"water_budget_error", "1",
         share(((water - first_water_) - rain) + left, {water, first_water_, rain, left})},
        {"sediment_volume", "m3", sediment},
        {"sediment_removed", "m3", removed},
        {"sediment_budget_error", "1", share(sediment + removed, {sediment, removed, in_relief})},
        {"substeps", "1", static_cast<double>(substeps_)}};
}

Snapshot Gully::snapshot() const {
    Snapshot snapshot{steps_, time(), std::string(time_unit()), bed_, domain_.nodata, scale_};
    snapshot.landform = landform;
    snapshot.periodic =
        domain_.edges_x == EdgeKind::periodic && domain_.edges_y == EdgeKind::periodic;
    snapshot.fields = {{"water_depth", "depth of the water", "m", water_.depth},
                       {"velocity_x", "eastward velocity of the water", "m/s", water_.velocity_x},
                       {"velocity_y", "northward velocity of the water", "m/s", water_.velocity_y}};
    snapshot.numbers = budgets();
    return snapshot;
}

std::vector<StateField> Gully::state() const {
    std::vector<StateField> fields{{"bed", bed_.values()},
                                   {"water_depth", water_.depth.values()},
                                   {"velocity_x", water_.velocity_x.values()},
                                   {"velocity_y", water_.velocity_y.values()}};
    const auto own = scheme_->state();
    fields.insert(fields.end(), own.begin(), own.end());
    fields.push_back({"counters", counters_});
    return fields;
}

void Gully::carry(StateCarrier& carrier) {
    carrier.count("steps", steps_);
    carrier.count("substeps", substeps_);
    carrier.values("bed", bed_.values());
    carrier.values("water_depth", water_.depth.values());
    carrier.values("velocity_x", water_.velocity_x.values());
    carrier.values("velocity_y", water_.velocity_y.values());
    scheme_->carry(carrier);
    sediment_.carry(carrier);
    rain_.carry("rain_volume", carrier);
    carrier.values("counters", counters_);
}

}  // namespace fumon
