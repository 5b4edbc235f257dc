#include "models/dunes/dunes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"
#include "base/state_archive.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/dunes/setup/ground_features.h"
#include "models/dunes/transport/saturation_hops.h"
#include "models/dunes/wind/wind_strength.h"

namespace fumon {

namespace {

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

DuneGround ground_of(const DunesParameters& parameters, const ModelSetup& setup) {
    return {setup.bed.nx(),
            setup.bed.ny(),
            setup.scale.dx,
            setup.scale.dy,
            parameters.edges_x == DuneEdge::periodic,
            parameters.edges_y == DuneEdge::periodic};
}

void check_angles(const DunesParameters& parameters) {
    if (parameters.static_angle < parameters.repose_angle) {
        throw KeyError("model.static_angle",
                       fmt::format("model.static_angle is {}, below model.repose_angle = {}; sand "
                                   "at rest holds at least as steep a slope as sliding sand",
                                   parameters.static_angle, parameters.repose_angle));
    }
    if (parameters.shadow == DuneShadow::soft &&
        parameters.shadow_soft_angle >= parameters.shadow_angle) {
        throw KeyError("model.shadow_soft_angle",
                       fmt::format("model.shadow_soft_angle is {} and model.shadow_angle {}; a "
                                   "soft shadow begins at the smaller angle",
                                   parameters.shadow_soft_angle, parameters.shadow_angle));
    }
}

void check_winds(const DunesParameters& parameters) {
    for (std::size_t n = 0; n < parameters.winds.size(); ++n) {
        if (!parameters.winds[n].threshold_ratio.is_word() &&
            parameters.speed_up != DuneSpeedUp::relief) {
            throw KeyError(fmt::format("wind.{}.threshold_ratio", n),
                           "a threshold needs the shear stress over relief; write "
                           "model.speed_up = \"relief\", or threshold_ratio = \"none\"");
        }
        if (parameters.winds[n].table.empty()) continue;
        throw KeyError(fmt::format("wind.{}.table", n),
                       fmt::format("the winds of {} were not read", parameters.winds[n].table));
    }
}

void check_transport(const DunesParameters& parameters, const ModelSetup& setup) {
    if (parameters.transport == DuneTransport::slabs &&
        parameters.speed_up == DuneSpeedUp::relief) {
        throw KeyError(
            "model.speed_up",
            "slab transport has no shear stress; write model.speed_up = \"height\" or \"none\", "
            "or model.transport = \"continuous\"");
    }
    if (parameters.order == SlabOrder::sequential && parameters.influx > 0.0 &&
        parameters.transport == DuneTransport::slabs) {
        throw KeyError("model.influx",
                       "slabs that hop in sequence take no influx; write model.order = "
                       "\"parallel\", or no model.influx");
    }
    if (parameters.transport == DuneTransport::slabs && parameters.rock_wear > 0.0) {
        throw KeyError(
            "model.rock_wear",
            "slab transport wears no rock; write model.transport = \"continuous\", or no "
            "model.rock_wear");
    }
    if (parameters.rock_wear == 0.0 && !parameters.abrasion_height.is_word()) {
        throw KeyError("model.abrasion_height",
                       "no rock is worn; write model.rock_wear, or model.abrasion_height = "
                       "\"none\"");
    }
    if (parameters.rock_wear == 0.0 && parameters.rock_dust > 0.0) {
        throw KeyError("model.rock_dust",
                       "no rock is worn; write model.rock_wear, or no model.rock_dust");
    }
    if (parameters.wall_angle.is_word() && parameters.wall_drift > 0.0) {
        throw KeyError("model.wall_drift",
                       "there are no walls; write model.wall_angle, or no model.wall_drift");
    }
    if (parameters.transport == DuneTransport::slabs && !parameters.wall_angle.is_word()) {
        throw KeyError("model.wall_angle",
                       "slab transport has no walls; write model.transport = \"continuous\", or "
                       "model.wall_angle = \"none\"");
    }
    const double box = std::min(setup.bed.nx() * setup.scale.dx, setup.bed.ny() * setup.scale.dy);
    const double widest = std::max(setup.bed.nx() * setup.scale.dx, box);
    if (parameters.hop_length > widest) {
        throw KeyError("model.hop_length",
                       fmt::format("hops of {:.4g} m exceed the box of {:.4g} m; take a wider grid "
                                   "or shorter hops",
                                   parameters.hop_length, widest));
    }
}

void check_heights(const ModelSetup& setup) {
    if (!setup.nodata.empty()) {
        throw KeyError("bed.file",
                       "the bed has cells without data, over which sand cannot hop; write "
                       "bed.nodata = \"fill\" or give them a height");
    }
    constexpr double highest = 1e5;  // m
    for (const double height : setup.bed.values()) {
        if (std::abs(height) <= highest) continue;
        throw KeyError("bed.kind", fmt::format("the bed has a height of {:.6g} m; dunes take beds "
                                               "within {:.0f} m of 0",
                                               height, highest));
    }
}

void check_ravines(const DunesParameters& parameters) {
    for (std::size_t n = 0; n < parameters.features.size(); ++n) {
        const DuneFeature& feature = parameters.features[n];
        if (feature.ravines > 0.0 && feature.kind != FeatureKind::rock)
            throw KeyError(fmt::format("feature.{}.ravines", n),
                           "only rock has ravines; leave it out, or write kind = \"rock\"");
    }
}

void check_plants(const DunesParameters& parameters) {
    if (parameters.plants != DunePlants::none) return;
    for (std::size_t n = 0; n < parameters.features.size(); ++n) {
        const FeatureKind kind = parameters.features[n].kind;
        if (kind == FeatureKind::rock || kind == FeatureKind::sand || kind == FeatureKind::source)
            continue;
        throw KeyError(fmt::format("feature.{}.kind", n),
                       "there are no plants; write model.plants = \"grow\" or \"fixed\"");
    }
    if (parameters.grass.cover > 0.0 || parameters.shrubs.cover > 0.0) {
        throw KeyError(parameters.grass.cover > 0.0 ? "model.grass_cover" : "model.shrub_cover",
                       "there are no plants; write model.plants = \"grow\" or \"fixed\"");
    }
}

DuneBed first_bed(const DunesParameters& parameters, const ModelSetup& setup) {
    check_heights(setup);
    const int nx = setup.bed.nx();
    const int ny = setup.bed.ny();
    DuneBed bed{FixedPointGrid(nx, ny), FixedPointGrid(nx, ny), FixedPointGrid(nx, ny)};
    const std::int64_t cover = to_units(parameters.sand_cover);
    const std::int64_t level = to_units(parameters.rock_level);
    double sand = 0.0;
    for (std::size_t cell = 0; cell < bed.surface.size(); ++cell) {
        const std::int64_t height = to_units(setup.bed.values()[cell]);
        const bool is_rock = parameters.rock == DuneRock::bed;
        bed.surface.values()[cell] = is_rock ? height + cover : height;
        bed.rock.values()[cell] = is_rock ? height : level;
        const std::int64_t thickness = bed.surface.values()[cell] - bed.rock.values()[cell];
        if (thickness < 0) {
            throw KeyError("model.rock_level",
                           fmt::format("the bed lies at {:.6g} m, below model.rock_level = {:.6g}; "
                                       "lower the rock, or write model.rock = \"bed\"",
                                       setup.bed.values()[cell], parameters.rock_level));
        }
    }
    set_features(parameters.features, ground_of(parameters, setup), setup.seed, bed);
    for (std::size_t cell = 0; cell < bed.surface.size(); ++cell)
        sand += to_metres(bed.surface.values()[cell] - bed.rock.values()[cell]);
    constexpr double most_sand = 0x1p29;  // m: a quarter of what 64 bits hold
    if (sand > most_sand) {
        throw KeyError(
            "model.rock_level",
            fmt::format("there are {:.4g} m of sand over all cells, more than the {:.4g} "
                        "that are counted exactly; raise model.rock_level",
                        sand, most_sand));
    }
    return bed;
}

double slab_height_of(const DunesParameters& parameters, const DuneGround& ground) {
    constexpr double aspect = 3.0;
    return parameters.slab_height.is_word() ? std::min(ground.dx, ground.dy) / aspect
                                            : parameters.slab_height.value;
}

/// Years that a step takes under a wind of that strength.
double step_length(const DunesParameters& parameters, const DuneGround& ground, double strength) {
    const double saturation = saturation_length(parameters, ground);
    if (parameters.transport == DuneTransport::slabs)
        return slab_height_of(parameters, ground) * saturation / (parameters.flux * strength);
    constexpr double taken = 0.03;  // of a cell's size
    const double strongest = strongest_wind(parameters);
    return parameters.time_step.is_word()
               ? taken * std::min(ground.dx, ground.dy) * saturation / (parameters.flux * strongest)
               : parameters.time_step.value;
}

/// What no bed of a checkpoint exceeds.
constexpr double highest_bed = 5e5;  // m: 2⁵¹ units and less, see whole_numbers-inl.h

}  // namespace

Dunes::Dunes(const DunesParameters& parameters, const ModelSetup& setup)
    : parameters_(with_wind_strengths(parameters)),
      scale_(setup.scale),
      ground_(ground_of(parameters, setup)),
      pool_(setup.pool),
      shadow_tangents_{tangent(parameters.shadow == DuneShadow::soft ? parameters.shadow_soft_angle
                                                                     : parameters.shadow_angle),
                       tangent(parameters.shadow_angle)},
      slab_height_(slab_height_of(parameters, ground_)),
      schedule_(
          parameters_.winds,
          [&](double strength) { return step_length(parameters_, ground_, strength); }, setup.seed),
      bed_(first_bed(parameters, setup)),
      slopes_(
          {ground_.nx, ground_.ny, ground_.dx, ground_.dy, ground_.periodic_x, ground_.periodic_y},
          {parameters.static_angle, parameters.repose_angle}, setup.pool),
      shadow_(ground_, setup.pool) {
    check_winds(parameters_);
    check_angles(parameters);
    check_transport(parameters, setup);
    check_saturation(parameters, ground_);
    check_windward_bubbles(parameters);
    check_wind_bend(parameters);
    check_plants(parameters);
    check_plant_shelter(parameters);
    check_ravines(parameters);
    sources_ = sources_of(parameters.features, ground_);
    if (parameters.plants != DunePlants::none) {
        plants_.emplace(parameters, ground_, bed_, setup.seed, pool_);
        if (parameters.plant_shelter != DunePlantShelter::none)
            shelter_.emplace(parameters, ground_, pool_);
        take_plants();
    }
    if (parameters.avalanche_age) {
        slopes_.track_slid_cells();
        slid_at_ = FixedPointGrid(ground_.nx, ground_.ny);
    }
    if (parameters.transport == DuneTransport::slabs) {
        slabs_.emplace(parameters_, ground_, slab_height_, shadow_tangents_, setup.seed, pool_);
        return;
    }
    continuous_.emplace(parameters_, ground_, step_length(parameters_, ground_, 1.0), pool_);
    if (parameters.speed_up == DuneSpeedUp::relief) {
        shear_.emplace(ground_, parameters.shear_in_phase, parameters.shear_ahead, pool_);
        relief_ = Grid(ground_.nx, ground_.ny);
    }
    if (!parameters.windward_angle.is_word())
        bubbles_.emplace(ground_, tangent(parameters.windward_angle.value), pool_);
    if (parameters.wind_bend != DuneBend::none || parameters.slope_deflection > 0.0)
        bent_ = {Grid(ground_.nx, ground_.ny), Grid(ground_.nx, ground_.ny)};
    if (parameters.wind_bend == DuneBend::contours) contour_bend_.emplace(ground_, pool_);
    if (parameters.rock_wear > 0.0) {
        rock_wear_.emplace(
            ground_,
            RockWear::Rule{parameters.rock_wear, tangent(parameters.rock_repose_angle),
                           parameters.abrasion_height.value, parameters.rock_dust},
            pool_);
    }
    if (!parameters.wall_angle.is_word())
        walls_.emplace(ground_, tangent(parameters.wall_angle.value), parameters.wall_drift, pool_);
}

void Dunes::take_plants() {
    slopes_.set_moving_angles(plants_->angles());
    if (shelter_) shelter_->set_plants(*plants_);
}

void Dunes::step() {
    const BlowingWind wind = schedule_.at(steps_);
    const int most_passes = static_cast<int>(parameters_.avalanche_passes);
    if (slabs_) {
        SlabTransport::Avalanches avalanches{slopes_, most_passes};
        slabs_->step(bed_, wind, plants_ ? &*plants_ : nullptr, steps_, shadow_, avalanches);
        passes_ = avalanches.passes;
        at_rest_ = avalanches.at_rest;
    } else {
        blow_continuously(wind);
        const auto outcome = slopes_.relax(bed_.surface, bed_.rock, most_passes);
        passes_ = outcome.passes;
        at_rest_ = outcome.at_rest;
    }
    fill_sources();
    if (parameters_.avalanche_age) note_slides();
    if (plants_ && plants_->grow(bed_, schedule_.time(steps_ + 1), steps_)) take_plants();
    ++steps_;
}

void Dunes::note_slides() {
    slopes_.drain_slid_cells([&](int x, int y) { slid_at_(x, y) = steps_ + 1; });
}

void Dunes::find_wind(const BlowingWind& wind) const {
    shadow_.cast(bed_.surface, wind, shadow_tangents_,
                 shear_ ? WindShadow::Find::shade_and_envelope : WindShadow::Find::shade);
    if (shear_) {
        if (parameters_.wind_bend == DuneBend::shear) {
            relief_ = shadow_.envelope();
        } else {
            shadow_.swap_envelope(relief_);
        }
        if (bubbles_) bubbles_->find(bed_.surface, wind).fill(relief_);
        shear_->apply(relief_, wind);
    }
    if (!bent_.x.empty()) bend(wind);
    if (walls_) walls_->find(bed_.surface, wind);
    wind_found_at_ = steps_;
}

WindOverBed Dunes::wind_over_bed(const BlowingWind& wind) const {
    if (wind_found_at_ != steps_) find_wind(wind);
    WindOverBed over{wind, shadow_.shade()};
    if (shear_) over.shear = &relief_;
    if (!bent_.x.empty()) over.bent = &bent_;
    if (walls_) {
        over.before_walls = &walls_->wind();
        if (parameters_.wall_drift > 0.0) over.along_walls = &walls_->aside();
    }
    return over;
}

void Dunes::bend(const BlowingWind& wind) const {
    if (contour_bend_) {
        contour_bend_->find(bed_.surface, wind, bent_);
        return;
    }
    if (parameters_.wind_bend == DuneBend::shear) {
        across_ = shadow_.envelope();
        if (bubbles_) bubbles_->fill(across_);
        shear_->apply_across(across_, wind, parameters_.shear_across);
    } else {
        if (across_.empty()) across_ = Grid(ground_.nx, ground_.ny);
        std::ranges::fill(across_.values(), 0.0);
    }
    if (parameters_.slope_deflection > 0.0)
        turn_down_slopes(bed_.surface, ground_, wind, parameters_.slope_deflection, pool_, across_);
    turn_by_stress(across_, wind, pool_, bent_);
}

double Dunes::saturated_air() const {
    if (parameters_.transport == DuneTransport::slabs) return 0.0;
    const BlowingWind wind = schedule_.at(steps_);
    const SaturationHops hops = saturation_hops(parameters_, ground_, wind.x, wind.y);
    return parameters_.flux * step_length(parameters_, ground_, 1.0) * hops.kept / hops.length;
}

void Dunes::fill_sources() {
    for (std::size_t cell = 0; cell < sources_.size(); ++cell) {
        if (sources_.values()[cell] == 0) continue;
        const std::int64_t full = bed_.rock.values()[cell] + sources_.values()[cell];
        std::int64_t& surface = bed_.surface.values()[cell];
        if (surface >= full) continue;
        bed_.inflow += full - surface;
        surface = full;
    }
}

void Dunes::blow_continuously(const BlowingWind& wind) {
    WindOverBed over = wind_over_bed(wind);
    if (plants_) over.plants = &*plants_;
    if (shelter_) {
        shelter_->find(wind);
        over.sheltered = &shelter_->stress();
    }
    continuous_->step(bed_, over);
    if (rock_wear_) {
        rock_wear_->wear(bed_, wind, continuous_->landed(), continuous_->ended(),
                         plants_ ? &plants_->cover() : nullptr);
    }
}

void Dunes::serialise(StateArchive& archive) {
    wind_found_at_ = -1;
    archive.count("steps", steps_);
    archive.count("sand_inflow", bed_.inflow);
    archive.count("sand_outflow", bed_.outflow);
    archive.count("avalanche_passes", passes_);
    archive.value("avalanches_at_rest", at_rest_);
    archive.values("surface", bed_.surface.values());
    archive.values("rock", bed_.rock.values());
    archive.values("moving_sand", bed_.moving.values());
    if (rock_wear_) archive.count("rock_worn", bed_.worn);
    if (plants_) {
        plants_->serialise(archive);
        take_plants();
    }
    if (parameters_.avalanche_age) {
        archive.values("slid_at", slid_at_.values());
        for (const std::int64_t step : slid_at_.values()) {
            if (step < 0 || step > steps_) archive.refuse("it has avalanches of future steps");
        }
    }
    const std::int64_t highest = to_units(highest_bed);
    for (std::size_t cell = 0; cell < bed_.surface.size(); ++cell) {
        const std::int64_t surface = bed_.surface.values()[cell];
        const std::int64_t rock = bed_.rock.values()[cell];
        const std::int64_t moving = bed_.moving.values()[cell];
        if (surface > highest || rock < -highest || moving > highest)
            archive.refuse("it has cells of an impossible height");
        if (surface < rock || moving < 0)
            archive.refuse("it has cells with a negative amount of sand");
    }
}

}  // namespace fumon
