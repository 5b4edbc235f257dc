#include "models/water/gully.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/state_archive.h"
#include "base/worker_pool.h"
#include "models/shared/two_cell_pattern.h"
#include "models/shared/unstable.h"
#include "models/water/kernels/fault_vectors.h"
#include "models/water/shallow_water.h"

namespace fumon {

namespace {

[[noreturn]] void report(const Water& water, const Grid& bed, int y, double time) {
    const auto fail = [&](const char* quantity, double value, const char* unit, int x) {
        throw Unstable(fmt::format("{} became {:.4g} {} at cell ({}, {}), t = {:.6g} s", quantity,
                                   value, unit, x, y, time),
                       "a smaller model.courant_number or model.time_step, more "
                       "model.bed_diffusion or model.scheme = \"cip\"");
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
    throw Error(
        fmt::format("the water in row {} changed between two checks, t = {:.6g} s", y, time));
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
void refuse_speed(const Water& water, double time, const std::string& reason,
                  const std::string& remedies) {
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
    throw Unstable(
        fmt::format("the speed became {:.4g} m/s at cell ({}, {}), t = {:.6g} s, so that {}",
                    speed(fastest_x, fastest_y), fastest_x, fastest_y, time, reason),
        remedies);
}

/// What slows the water, and the ground that it digs itself down into.
std::string remedies_of_speed(const GullyParameters& parameters) {
    const bool has_loads = parameters.transport == SedimentTransport::loads;
    const bool digs = !has_loads && parameters.transport_factor.value > 0.0;
    return fmt::format(
        "a smaller {}model.time_step, more model.friction_coefficient or model.bed_diffusion",
        has_loads ? "model.morphological_factor or "
        : digs    ? "model.transport_factor or "
                  : "");
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

/// The scheme, which finds the water at the start as it keeps it.
std::unique_ptr<ShallowWaterScheme> scheme_of(const GullyStart& start, WorkerPool& pool,
                                              Water& water) {
    std::unique_ptr<ShallowWaterScheme> scheme = make_water_scheme(start, pool);
    scheme->convert_to_means(water, start.bed);
    return scheme;
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
      on_terrain_(start.on_terrain),
      first_bed_(start.on_terrain || start.parameters.transport == SedimentTransport::loads
                     ? start.bed
                     : Grid()),
      water_(start.water),
      scheme_(scheme_of(start, pool, water_)),
      step_at_courant_one_(scheme_->step_at_courant_one(water_)),
      sediment_(parameters_, domain_, bed_.nx(), bed_.ny(), pool),
      loads_(make_loads(start, pool)),
      flows_(loads_ ? FaceFlows(bed_.nx(), bed_.ny()) : FaceFlows()),
      infiltration_(parameters_, start.soil, domain_.dx * domain_.dy, bed_.nx(), bed_.ny(), pool),
      gauges_(parameters_, domain_, scale_, bed_.nx(), bed_.ny()),
      cell_area_(domain_.dx * domain_.dy),
      wet_area_(cell_area_ * sum_of(bed_, domain_.nodata, [](double) { return 1.0; })),
      first_water_(water_volume()),
      first_bed_volume_(bed_volume()),
      rain_(std::make_shared<Rain>(parameters_, start.rain_maps)) {
    if (loads_) scheme_->record(flows_);
    if (WatchedFaces* faces = gauges_.faces()) scheme_->watch(*faces);
    check_time_step(parameters_,
                    std::min(step_at_courant_one_, scheme_->edge_step_at_courant_one(0.0, bed_)));
}

void Gully::step() {
    double remaining = parameters_.time_step;
    double elapsed = time();
    substeps_ = 0;
    gauges_.begin_step();
    while (remaining > 0.0) {
        throw_if_cancelled();
        const double dt = sub_step_size(remaining, elapsed);
        sub_step(dt, elapsed);
        remaining = dt == remaining ? 0.0 : remaining - dt;
        if (++substeps_ > most_substeps) {
            refuse_speed(water_, elapsed,
                         fmt::format("a step takes more than {} sub-steps", most_substeps),
                         remedies_of_speed(parameters_));
        }
    }
    if (transports_loads()) loads_->fail_banks(bed_);
    ++steps_;
    check_water(water_, bed_, time(), pool_);
    counters_ = {fallen_.value(), scheme_->left(), sediment_removed()};
}

std::int64_t Gully::resting_steps() const {
    constexpr double rounding = 1e-9;
    constexpr double most = 1e15;
    const double steps = parameters_.loads.bed_start / parameters_.time_step;
    return static_cast<std::int64_t>(std::ceil(std::min(steps, most) - rounding));
}

/// An equal share of what remains of the step, as large as the Courant number allows.
double Gully::sub_step_size(double remaining, double elapsed) const {
    if (parameters_.substeps == Substeps::fixed) return remaining;
    const double step_at_one =
        std::min(step_at_courant_one_, scheme_->edge_step_at_courant_one(elapsed, bed_));
    const double limit = parameters_.courant_number * step_at_one;
    constexpr double bed_courant_number = 0.5;
    const double of_bed =
        transports_loads() ? remaining * loads_->bed_rate() / bed_courant_number : 0.0;
    const double pieces = std::ceil(std::max(remaining / limit, of_bed) * (1.0 - 1e-12));
    if (pieces <= 1.0) return remaining;
    if (!(pieces <= most_substeps)) {
        check_water(water_, bed_, elapsed, pool_);
        if (of_bed > remaining / limit) {
            throw Unstable(
                fmt::format("the bed changes so fast at t = {:.6g} s that a step would take {:.3g} "
                            "sub-steps",
                            elapsed, pieces),
                "a smaller model.morphological_factor, model.entrainment_rate or model.time_step");
        }
        refuse_speed(water_, elapsed, fmt::format("a sub-step would be {:.3g} s", limit),
                     remedies_of_speed(parameters_));
    }
    return remaining / pieces;
}

void Gully::sub_step(double dt, double& elapsed) {
    const Rain::Step rain = rain_->over(elapsed, dt);
    scheme_->set_rain(rain.by_cell);
    scheme_->set_time(elapsed + 0.5 * dt);
    infiltration_.advance(water_.depth, elapsed, dt);
    const bool transporting = transports_loads();
    if (transporting) loads_->begin(water_.depth);
    step_at_courant_one_ = scheme_->advance(water_, bed_, dt, rain.even);
    gauges_.end_sub_step();
    fallen_.add(rain.by_cell == nullptr ? rain.even * dt * wet_area_ : rain.volume);
    if (transporting || !loads_)
        sediment_.advance(bed_, water_, loads_ ? dt * parameters_.loads.morphological_factor : dt);
    if (transporting)
        loads_->advance(bed_, {water_.depth, water_.velocity_x, water_.velocity_y}, flows_, dt);
    elapsed += dt;
}

double Gully::water_volume() const {
    return cell_area_ * sum_of(water_.depth, domain_.nodata, [](double h) { return h; });
}

double Gully::bed_volume() const {
    return cell_area_ * sum_of(bed_, domain_.nodata, [](double z) { return z; });
}

/// Bed volume that has gone over the edges or into nothing, less what came in.
double Gully::sediment_removed() const {
    if (!loads_) return sediment_.removed();
    return loads_->bed_factor() * (loads_->left() - loads_->entered());
}

std::vector<SnapshotNumber> Gully::budgets() const {
    const double water = water_volume();
    const double rain = fallen_.value();
    const double left = scheme_->left();
    const double sediment = bed_volume() - first_bed_volume_;
    const double removed = sediment_removed();
    const double suspended = loads_ ? loads_->bed_factor() * loads_->suspended() : 0.0;
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
        {"sediment_budget_error", "1",
         share((sediment + suspended) + removed, {sediment, suspended, removed, in_relief})},
        {"substeps", "1", static_cast<double>(substeps_)}};
    if (!domain_.segments.empty()) numbers.push_back({"entered_volume", "m3", entered});
    if (infiltration_.takes()) numbers.push_back({"infiltrated_volume", "m3", infiltrated});
    if (domain_.slope_x != 0.0) numbers.push_back({"mean_slope_x", "m/m", domain_.slope_x});
    return numbers;
}

/// What the water carries, and what that has made of the bed.
void Gully::add_loads(Snapshot& snapshot) const {
    if (!loads_) return;
    Grid change = bed_;
    CompensatedSum eroded;
    CompensatedSum deposited;
    for (std::size_t cell = 0; cell < bed_.size(); ++cell) {
        double& here = change.values()[cell];
        const bool outside = !domain_.nodata.empty() && domain_.nodata.values()[cell] != 0;
        here = outside ? 0.0 : here - first_bed_.values()[cell];
        (here < 0.0 ? eroded : deposited).add(std::fabs(here));
    }
    snapshot.fields.push_back({"concentration", "suspended grains, volume over the water's", "1",
                               loads_->concentration(water_.depth)});
    snapshot.fields.push_back({"bed_change", "bed less the bed at the start", "m", change});
    const double factor = parameters_.loads.morphological_factor;
    const double moving = static_cast<double>(steps_ - std::min(steps_, resting_steps()));
    const std::vector<SnapshotNumber> numbers{
        {"eroded_volume", "m3", cell_area_ * eroded.value()},
        {"deposited_volume", "m3", cell_area_ * deposited.value()},
        {"suspended_volume", "m3", loads_->suspended()},
        {"grains_left_volume", "m3", loads_->left()},
        {"grains_entered_volume", "m3", loads_->entered()},
        {"bed_time", "s", factor * (moving * parameters_.time_step)}};
    snapshot.numbers.insert(snapshot.numbers.end(), numbers.begin(), numbers.end());
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
    add_loads(snapshot);
    std::ranges::move(gauges_.read(water_, bed_), std::back_inserter(snapshot.numbers));
    snapshot.rain = [rain = std::shared_ptr<const Rain>(rain_)](double from, double until) {
        return rain->between(from, until);
    };
    return snapshot;
}

std::string Gully::plausibility_warning() const {
    const bool stays = parameters_.transport == SedimentTransport::none;
    if (!on_terrain_ || steps_ == 0 || stays || loads_) return {};
    constexpr double least = 1.0;               // m
    constexpr double plausible = 1.0 / 3600.0;  // m/s: a flood in loose ground
    const double expected = std::max(least, plausible * time());
    const double largest = largest_difference(bed_, first_bed_, pool_);
    if (!(largest > expected)) return furrow_warning(largest);
    double most = 0.0;
    std::size_t where = 0;
    for (std::size_t cell = 0; cell < bed_.size(); ++cell) {
        const double change = bed_.values()[cell] - first_bed_.values()[cell];
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

std::string Gully::furrow_warning(double largest) const {
    constexpr double seen = 0.005;        // m
    constexpr double least_share = 0.02;  // of the cells that have changed
    if (!(largest > seen)) return {};
    Grid change = bed_;
    for (std::size_t cell = 0; cell < change.size(); ++cell)
        change.values()[cell] -= first_bed_.values()[cell];
    const TwoCellPattern furrows = two_cell_pattern(change);
    if (!(furrows.share > least_share)) return {};
    const auto nx = static_cast<std::size_t>(bed_.nx());
    return fmt::format(
        "the bed has furrows of two cells ({:.0f} % of what has changed, deepest at cell ({}, "
        "{})), "
        "which are the grid's and not the water's: take more model.bed_diffusion, some times the "
        "{:g} m^2/s of this run, or a smaller model.transport_factor",
        100.0 * furrows.share, furrows.cell % nx, furrows.cell / nx,
        parameters_.bed_diffusion.value);
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
    if (loads_) std::ranges::move(loads_->state(), std::back_inserter(fields));
    fields.push_back({"counters", counters_});
    return fields;
}

void Gully::serialise(StateArchive& archive) {
    archive.count("steps", steps_);
    archive.count("substeps", substeps_);
    archive.values("bed", bed_.values());
    archive.values("water_depth", water_.depth.values());
    archive.values("velocity_x", water_.velocity_x.values());
    archive.values("velocity_y", water_.velocity_y.values());
    scheme_->serialise(archive);
    sediment_.serialise(archive);
    if (loads_) loads_->serialise(archive);
    infiltration_.serialise(archive);
    fallen_.serialise("rain_volume", archive);
    gauges_.serialise(archive);
    archive.values("counters", counters_);
    step_at_courant_one_ = scheme_->step_at_courant_one(water_);
}

}  // namespace fumon
