#include "models/water/gully.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/give_up.h"
#include "base/state_carrier.h"
#include "base/worker_pool.h"
#include "models/water/fault_vectors.h"
#include "models/water/shallow_water.h"
#include "numerics/time_table.h"

namespace fumon {

namespace {

[[noreturn]] void report(const Water& water, const Grid& bed, int y, double time) {
    const auto fail = [&](const char* quantity, double value, const char* unit, int x) {
        throw Error(
            fmt::format("{} became {:.4g} {} at cell ({}, {}), t = {:.6g} s; try a smaller "
                        "model.courant_number or model.time_step, more model.bed_diffusion or "
                        "model.scheme = \"cip\"",
                        quantity, value, unit, x, y, time));
    };
    for (int x = 0; x < bed.nx(); ++x) {
        const double depth = water.depth(x, y);
        if (!(depth >= 0.0) || std::isinf(depth)) fail("the water depth", depth, "m", x);
        const double u = water.velocity_x(x, y);
        if (!std::isfinite(u)) fail("the eastward velocity", u, "m/s", x);
        const double v = water.velocity_y(x, y);
        if (!std::isfinite(v)) fail("the northward velocity", v, "m/s", x);
        if (!std::isfinite(bed(x, y))) fail("the bed height", bed(x, y), "m", x);
    }
    throw Error(fmt::format("the water in row {} is not what it was, t = {:.6g} s", y, time));
}

/// Throws Error where a depth is negative or a depth, velocity or bed height is not a finite
/// number: it names the first such cell, the quantity, the time (s) and what to try.
void check_water(const Water& water, const Grid& bed, double time, WorkerPool& pool) {
    std::vector<char> faulty(static_cast<std::size_t>(bed.ny()));
    pool.for_ranges(bed.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const double fault =
                fault_of_row({water.depth.row(y).data(), water.velocity_x.row(y).data(),
                              water.velocity_y.row(y).data(), bed.row(y).data()},
                             bed.nx());
            faulty[static_cast<std::size_t>(y)] = fault == 0.0 ? 0 : 1;
        }
    });
    const auto first = std::find(faulty.begin(), faulty.end(), 1);
    if (first != faulty.end()) report(water, bed, static_cast<int>(first - faulty.begin()), time);
}

/// Throws the Error that the flow has become too fast to follow: it names the fastest cell, its
/// speed, and `reason`, which says what that asks of the sub-steps.
void refuse_speed(const Water& water, double time, const std::string& reason) {
    const auto speed = [&](int x, int y) {
        const double u = water.velocity_x(x, y);
        const double v = water.velocity_y(x, y);
        return std::sqrt(u * u + v * v);
    };
    int fastest_x = 0;
    int fastest_y = 0;
    for (int y = 0; y < water.depth.ny(); ++y) {
        for (int x = 0; x < water.depth.nx(); ++x) {
            if (!(speed(x, y) > speed(fastest_x, fastest_y))) continue;
            fastest_x = x;
            fastest_y = y;
        }
    }
    throw Error(
        fmt::format("the speed became {:.4g} m/s at cell ({}, {}), t = {:.6g} s, so that {}; try a "
                    "smaller model.time_step, more model.friction_coefficient or "
                    "model.bed_diffusion",
                    speed(fastest_x, fastest_y), fastest_x, fastest_y, time, reason));
}

double largest_difference(const Grid& a, const Grid& b, WorkerPool& pool) {
    std::vector<double> rows(static_cast<std::size_t>(a.ny()));
    pool.for_ranges(a.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            rows[static_cast<std::size_t>(y)] =
                largest_difference_of_row(a.row(y).data(), b.row(y).data(), a.nx());
        }
    });
    return *std::ranges::max_element(rows);
}

constexpr int most_substeps = 5000;

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
      first_terrain_(start.on_terrain ? start.bed : Grid()),
      water_(start.water),
      scheme_(make_water_scheme(start, pool)),
      step_at_courant_one_(scheme_->step_at_courant_one(water_)),
      sediment_(parameters_, domain_, bed_.nx(), bed_.ny(), pool),
      infiltration_(parameters_, domain_.dx * domain_.dy, bed_.nx(), bed_.ny(), pool),
      gauges_(parameters_, domain_, scale_, bed_.nx(), bed_.ny()),
      cell_area_(domain_.dx * domain_.dy),
      wet_area_(cell_area_ * sum_of(bed_, domain_.nodata, [](double) { return 1.0; })),
      first_water_(water_volume()),
      first_bed_(bed_volume()) {
    check_time_step(parameters_,
                    std::min(step_at_courant_one_, scheme_->edge_step_at_courant_one(0.0, bed_)));
}

void Gully::step() {
    double remaining = parameters_.time_step;
    double elapsed = time();
    substeps_ = 0;
    while (remaining > 0.0) {
        give_up_if_asked();
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
    const double step_at_one =
        std::min(step_at_courant_one_, scheme_->edge_step_at_courant_one(elapsed, bed_));
    const double limit = parameters_.courant_number * step_at_one;
    const double pieces = std::ceil(remaining / limit * (1.0 - 1e-12));
    if (pieces <= 1.0) return remaining;
    if (!(pieces <= most_substeps)) {
        check_water(water_, bed_, elapsed, pool_);
        refuse_speed(water_, elapsed, fmt::format("a sub-step would be {:.3g} s", limit));
    }
    return remaining / pieces;
}

/// The mean of a sub-step, m/s.
double Gully::rain_rate(double elapsed, double dt) const {
    if (!parameters_.rain_times.empty()) {
        return mean_of_stairs(parameters_.rain_times, parameters_.rain_rates, elapsed,
                              elapsed + dt) *
               millimetre_per_hour;
    }
    const double until = parameters_.rain_until > 0.0 ? parameters_.rain_until : elapsed + dt;
    const double raining = std::clamp(until - elapsed, 0.0, dt) / dt;
    return raining * parameters_.rain * millimetre_per_hour;
}

void Gully::sub_step(double dt, double& elapsed) {
    const double rain = rain_rate(elapsed, dt);
    scheme_->set_time(elapsed + 0.5 * dt);
    infiltration_.advance(water_.depth, elapsed, dt);
    step_at_courant_one_ = scheme_->advance(water_, bed_, dt, rain);
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
    const double entered = scheme_->entered();
    const double infiltrated = infiltration_.volume();
    std::vector<SnapshotNumber> numbers{
        {"mean_slope", "m/m", domain_.slope},
        {"gravity", "m/s2", parameters_.gravity},
        {"water_volume", "m3", water},
        {"rain_volume", "m3", rain},
        {"left_volume", "m3", left},
        {"water_budget_error", "1",
         share(((((water - first_water_) - rain) + left) - entered) + infiltrated,
               {water, first_water_, rain, left, entered, infiltrated})},
        {"sediment_volume", "m3", sediment},
        {"sediment_removed", "m3", removed},
        {"sediment_budget_error", "1", share(sediment + removed, {sediment, removed, in_relief})},
        {"substeps", "1", static_cast<double>(substeps_)}};
    if (!domain_.stretches.empty()) numbers.push_back({"entered_volume", "m3", entered});
    if (infiltration_.takes()) numbers.push_back({"infiltrated_volume", "m3", infiltrated});
    if (domain_.slope_x != 0.0) numbers.push_back({"mean_slope_x", "m/m", domain_.slope_x});
    return numbers;
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
    std::ranges::move(gauges_.read(water_, bed_), std::back_inserter(snapshot.numbers));
    return snapshot;
}

std::string Gully::doubt() const {
    const bool stays = parameters_.transport == SedimentTransport::none;
    if (first_terrain_.empty() || steps_ == 0 || stays) return {};
    constexpr double least = 1.0;               // m
    constexpr double plausible = 1.0 / 3600.0;  // m/s: a flood in loose ground
    const double expected = std::max(least, plausible * time());
    if (!(largest_difference(bed_, first_terrain_, pool_) > expected)) return {};
    double most = 0.0;
    std::size_t where = 0;
    for (std::size_t cell = 0; cell < bed_.size(); ++cell) {
        const double change = bed_.values()[cell] - first_terrain_.values()[cell];
        if (!(std::fabs(change) > std::fabs(most))) continue;
        most = change;
        where = cell;
    }
    const auto nx = static_cast<std::size_t>(bed_.nx());
    const double rate = std::fabs(most) / (time() * plausible);  // in metres an hour
    const bool transported = parameters_.transport_factor.value > 0.0;
    const std::string remedy =
        transported ? fmt::format("a smaller model.transport_factor, about {:.0e} instead of {:g}",
                                  parameters_.transport_factor.value / rate,
                                  parameters_.transport_factor.value)
                    : fmt::format("less model.bed_diffusion than {:g} m^2/s",
                                  parameters_.bed_diffusion.value);
    return fmt::format(
        "the bed {} {:.3g} m at cell ({}, {}) in the first {:.4g} s, {:.2g} m an hour, where even "
        "a flood in loose ground cuts about 1: take {}",
        most < 0.0 ? "sank by" : "rose by", std::fabs(most), where % nx, where / nx, time(), rate,
        remedy);
}

std::vector<StateField> Gully::state() const {
    std::vector<StateField> fields{{"bed", bed_.values()},
                                   {"water_depth", water_.depth.values()},
                                   {"velocity_x", water_.velocity_x.values()},
                                   {"velocity_y", water_.velocity_y.values()}};
    const auto own = scheme_->state();
    fields.insert(fields.end(), own.begin(), own.end());
    if (!infiltration_.total().empty())
        fields.push_back({"infiltrated", infiltration_.total().values()});
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
    infiltration_.carry(carrier);
    rain_.carry("rain_volume", carrier);
    carrier.values("counters", counters_);
    step_at_courant_one_ = scheme_->step_at_courant_one(water_);
}

}  // namespace fumon
