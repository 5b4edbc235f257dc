#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "models/dunes/dunes.h"

namespace fumon {

namespace {

Grid in_metres(const FixedPointGrid& whole) {
    Grid grid(whole.nx(), whole.ny());
    std::ranges::transform(whole.values(), grid.values().begin(), to_metres);
    return grid;
}

/// Of sand at rest and moving, as a thickness of one cell.
double total_sand(const DuneBed& bed) {
    double sum = 0.0;
    for (std::size_t cell = 0; cell < bed.surface.size(); ++cell) {
        sum += to_metres(bed.surface.values()[cell] - bed.rock.values()[cell] +
                         bed.moving.values()[cell]);
    }
    return sum;
}

/// Of a snapshot's moving sand, `saturated` of which is in the air over flat sand; where none stays
/// there between steps, of what the wind lifts.
Grid flux_of_fields(const Snapshot& snapshot, double saturated) {
    const Grid* moving = field_of(snapshot.fields, "moving_sand");
    const Grid* lifted = field_of(snapshot.fields, "local_wind");
    const Grid* sand = field_of(snapshot.fields, "sand");
    if (moving == nullptr || lifted == nullptr || sand == nullptr)
        throw Error("the sand that wind drives over dunes does not follow from a bed alone");
    Grid flux = *moving;
    if (saturated > 0.0) {
        for (double& value : flux.values()) value /= saturated;
        return flux;
    }
    std::ranges::transform(lifted->values(), sand->values(), flux.values().begin(),
                           [](double wind, double loose) { return loose > 0.0 ? wind : 0.0; });
    return flux;
}

}  // namespace

Grid Dunes::local_wind() const {
    const BlowingWind wind = schedule_.at(steps_);
    const WindOverBed over = wind_over_bed(wind);
    Grid local(ground_.nx, ground_.ny);
    for (int y = 0; y < ground_.ny; ++y) {
        for (int x = 0; x < ground_.nx; ++x) local(x, y) = lift_factor(over, x, y);
    }
    return local;
}

/// Of the wind that local_wind() has found.
Grid Dunes::wind_turn() const {
    const BlowingWind wind = schedule_.at(steps_);
    Grid turn(ground_.nx, ground_.ny);
    for (std::size_t cell = 0; cell < turn.size(); ++cell) {
        const double x = bent_.x.values()[cell];
        const double y = bent_.y.values()[cell];
        turn.values()[cell] = elementary::atan2(wind.x * y - wind.y * x, wind.x * x + wind.y * y) *
                              degrees_per_radian;
    }
    return turn;
}

Grid Dunes::avalanche_age() const {
    Grid age(ground_.nx, ground_.ny);
    std::ranges::transform(slid_at_.values(), age.values().begin(),
                           [&](std::int64_t step) { return time() - schedule_.time(step); });
    return age;
}

Snapshot Dunes::snapshot() const {
    Snapshot snapshot{steps_, time(), std::string(time_unit()), in_metres(bed_.surface),
                      {},     scale_};
    snapshot.landform = landform;
    snapshot.periodic = ground_.periodic_x && ground_.periodic_y;
    snapshot.winds = schedule_.drifts(parameters_.flux);
    Grid sand = snapshot.bed;
    Grid rock = in_metres(bed_.rock);
    std::ranges::transform(sand.values(), rock.values(), sand.values().begin(), std::minus<>());
    Grid local = local_wind();
    constexpr std::size_t most_fields = 10;
    snapshot.fields.reserve(most_fields);
    const auto add = [&](const char* name, const char* long_name, const char* unit, Grid values) {
        snapshot.fields.push_back({name, long_name, unit, std::move(values)});
    };
    add("sand", "thickness of the sand at rest", "m", std::move(sand));
    add("rock", "height of the hard floor", "m", std::move(rock));
    add("moving_sand", "sand in the air, as a thickness", "m", in_metres(bed_.moving));
    add("wind_shadow", "how far ground upwind keeps the wind off, 0 to 1", "1", shadow_.shade());
    add("local_wind", "drift that the wind lifts there, in parts of that over flat ground", "1",
        std::move(local));
    if (!bent_.x.empty()) {
        snapshot.fields.push_back({"wind_turn",
                                   "by how much relief turns the wind, counterclockwise", "degrees",
                                   wind_turn()});
    }
    snapshot.saltation_flux = [saturated = saturated_air()](const Snapshot& of) {
        return flux_of_fields(of, saturated);
    };
    const double area = ground_.dx * ground_.dy;
    snapshot.numbers = {{"sand_volume", "m3", area * total_sand(bed_)},
                        {"sand_inflow", "m3", area * to_metres(bed_.inflow)},
                        {"sand_outflow", "m3", area * to_metres(bed_.outflow)},
                        {"avalanche_passes", "1", static_cast<double>(passes_)}};
    if (rock_wear_) snapshot.numbers.push_back({"rock_worn", "m3", area * to_metres(bed_.worn)});
    if (parameters_.winds.size() > 1) {
        const BlowingWind wind = schedule_.at(steps_);
        const double from = elementary::atan2(-wind.x, -wind.y) * degrees_per_radian;
        snapshot.numbers.push_back({"wind_from", "degrees", from < 0.0 ? from + 360.0 : from});
    }
    if (plants_) add_plants(snapshot);
    if (parameters_.avalanche_age) {
        snapshot.fields.push_back(
            {"avalanche_age", "time since sand last slid from the cell", "yr", avalanche_age()});
    }
    return snapshot;
}

void Dunes::add_plants(Snapshot& snapshot) const {
    snapshot.fields.push_back({"cover", "plants of both species, 0 to 1", "1", plants_->cover()});
    snapshot.fields.push_back({"grass", "grass, 0 to 1", "1", plants_->grass()});
    snapshot.fields.push_back({"shrubs", "shrubs, 0 to 1", "1", plants_->shrubs()});
    snapshot.grass_height = parameters_.grass.height;
    snapshot.shrub_height = parameters_.shrubs.height;
    if (shelter_) {
        shelter_->find(schedule_.at(steps_));
        Grid slowed(ground_.nx, ground_.ny);
        std::ranges::transform(shelter_->stress().values(), slowed.values().begin(),
                               [](double stress) { return 1.0 - std::sqrt(stress); });
        snapshot.fields.push_back({"plant_shelter",
                                   "by how much plants slow the wind's friction velocity, 0 to 1",
                                   "1", std::move(slowed)});
    }
    const auto cover = plants_->cover().values();
    snapshot.numbers.push_back(
        {"plant_cover", "1",
         std::accumulate(cover.begin(), cover.end(), 0.0) / static_cast<double>(cover.size())});
}

std::string Dunes::plausibility_warning() const {
    if (at_rest_) return {};
    return fmt::format(
        "avalanches had not come to rest after model.avalanche_passes = {} passes, so slopes "
        "exceed model.repose_angle; raise model.avalanche_passes, or shorten model.time_step",
        parameters_.avalanche_passes);
}

std::vector<StateField> Dunes::state() const {
    state_bed_ = in_metres(bed_.surface);
    state_rock_ = in_metres(bed_.rock);
    state_moving_ = in_metres(bed_.moving);
    state_flows_ = {to_metres(bed_.inflow), to_metres(bed_.outflow)};
    std::vector<StateField> state{{"bed", state_bed_.values()},
                                  {"rock", state_rock_.values()},
                                  {"moving_sand", state_moving_.values()},
                                  {"flows", state_flows_}};
    if (rock_wear_) {
        state_worn_ = {to_metres(bed_.worn)};
        state.push_back({"worn", state_worn_});
    }
    if (plants_) {
        state_grass_ = plants_->grass();
        state_shrubs_ = plants_->shrubs();
        state_surface_at_last_growth_ = in_metres(plants_->surface_at_last_growth());
        state_time_of_last_growth_ = {plants_->time_of_last_growth()};
        state.push_back({"grass", state_grass_.values()});
        state.push_back({"shrubs", state_shrubs_.values()});
        state.push_back({"surface_at_growth", state_surface_at_last_growth_.values()});
        state.push_back({"time_of_growth", state_time_of_last_growth_});
    }
    return state;
}

}  // namespace fumon
