#include "models/dunes/plants/plants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/random.h"
#include "base/state_archive.h"
#include "base/worker_pool.h"
#include "models/dunes/setup/ground_features.h"

namespace fumon {

namespace {

constexpr std::int64_t whole_cover = std::int64_t{1} << 32;

/// Sand this thick gives hold to a plant's roots. Metres.
constexpr double rooting_depth = 0.05;

/// From this cover on sand is as steep as under plants (Keijsers et al. 2016).
constexpr double steep_cover = 0.3;

std::int64_t to_cover(double share) {
    return std::llround(share * static_cast<double>(whole_cover));
}

double in_part(std::int64_t cover) {
    return static_cast<double>(cover) / static_cast<double>(whole_cover);
}

GrowthLaw law_of(const DuneSpecies& species, const std::string& key) {
    GrowthLaw law;
    law.growth = species.growth;
    std::copy_n(species.balances.begin(), law.balances.size(), law.balances.begin());
    for (std::size_t n = 1; n < law.balances.size(); ++n) {
        if (law.balances[n] > law.balances[n - 1]) continue;
        throw KeyError(key, fmt::format("{} has {} after {}; write five rates, each higher than "
                                        "the one before",
                                        key, law.balances[n], law.balances[n - 1]));
    }
    return law;
}

}  // namespace

Plants::Plants(const DunesParameters& parameters, const DuneGround& ground, const DuneBed& bed,
               std::uint64_t seed, WorkerPool& pool)
    : ground_(ground),
      pool_(pool),
      seed_(seed),
      grows_(parameters.plants == DunePlants::grow),
      period_(parameters.growth_period),
      pioneers_(parameters.plant_pioneers * ground.dx * ground.dy),
      spread_(parameters.plant_spread / std::min(ground.dx, ground.dy)),
      without_lift_(parameters.cover_without_lift),
      bare_angle_(parameters.repose_angle),
      plant_angle_(parameters.plant_repose_angle),
      surface_at_last_growth_(bed.surface),
      cover_(ground.nx, ground.ny) {
    if (plant_angle_ < bare_angle_) {
        throw KeyError("model.plant_repose_angle",
                       fmt::format("model.plant_repose_angle is {}, below model.repose_angle = {}; "
                                   "sand under plants rests at least as steeply as bare sand",
                                   plant_angle_, bare_angle_));
    }
    species_[0].law = law_of(parameters.grass, "model.grass_balances");
    species_[1].law = law_of(parameters.shrubs, "model.shrub_balances");
    plant(parameters.grass, FeatureKind::grass, parameters, 0, seed);
    plant(parameters.shrubs, FeatureKind::shrubs, parameters, 1, seed);
    find_cover();
}

void Plants::plant(const DuneSpecies& asked, FeatureKind kind, const DunesParameters& parameters,
                   std::size_t index, std::uint64_t seed) {
    Grid share(ground_.nx, ground_.ny, 1.0);
    const auto of_kind = [&](const DuneFeature& feature) { return feature.kind == kind; };
    if (std::ranges::any_of(parameters.features, of_kind)) share = Grid(ground_.nx, ground_.ny);
    for (const DuneFeature& feature : parameters.features) {
        const bool clears = feature.kind == FeatureKind::clearing;
        if (!clears && !of_kind(feature)) continue;
        const Grid shape = feature_shape(feature, ground_);
        for (std::size_t cell = 0; cell < share.size(); ++cell) {
            double& here = share.values()[cell];
            const double part = shape.values()[cell];
            here = clears ? here * (1.0 - part) : std::max(here, part);
        }
    }
    FixedPointGrid& cover = species_[index].cover;
    cover = FixedPointGrid(ground_.nx, ground_.ny);
    for (int y = 0; y < ground_.ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), static_cast<std::int64_t>(index),
                            Purpose::first_plants);
        for (int x = 0; x < ground_.nx; ++x) {
            if (stream.uniform() < asked.share) cover(x, y) = to_cover(asked.cover * share(x, y));
        }
    }
    species_[index].before = FixedPointGrid(ground_.nx, ground_.ny);
}

bool Plants::grow(const DuneBed& bed, double time, std::int64_t step) {
    constexpr double rounding = 1e-9;
    const double years = time - time_of_last_growth_;
    if (!grows_ || years < period_ * (1.0 - rounding)) return false;
    for (std::size_t index = 0; index < species_.size(); ++index) {
        Species& species = species_[index];
        std::swap(species.cover, species.before);
        const std::int64_t draw = 2 * step + static_cast<std::int64_t>(index);
        pool_.for_ranges(ground_.ny, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                grow_row(species, bed, years, draw, y);
            }
        });
    }
    surface_at_last_growth_ = bed.surface;
    time_of_last_growth_ = time;
    find_cover();
    return true;
}

void Plants::grow_row(Species& species, const DuneBed& bed, double years, std::int64_t step,
                      int y) {
    RandomStream stream(seed_, static_cast<std::uint32_t>(y), step, Purpose::plants);
    for (int x = 0; x < ground_.nx; ++x) {
        const std::int64_t before = species.before(x, y);
        const double rise = to_metres(bed.surface(x, y) - surface_at_last_growth_(x, y));
        // Any more would be no other: a cover is gone or whole.
        const double change = std::clamp(years * species.law.at(rise / years), -1.0, 1.0);
        std::int64_t& cover = species.cover(x, y);
        cover = before;
        if (before == 0) {
            const double chance =
                years * (pioneers_ + (beside(species.before, x, y) ? spread_ : 0.0));
            if (!(change > 0.0) || to_metres(bed.surface(x, y) - bed.rock(x, y)) < rooting_depth ||
                stream.uniform() >= chance)
                continue;
        }
        cover = std::clamp(before + to_cover(change), std::int64_t{0}, whole_cover);
    }
}

bool Plants::beside(const FixedPointGrid& cover, int x, int y) const {
    const auto place = [](int cell, int count, bool periodic) {
        if (cell >= 0 && cell < count) return cell;
        return !periodic ? std::clamp(cell, 0, count - 1) : (cell + count) % count;
    };
    const auto column = [&](int cell) { return place(cell, ground_.nx, ground_.periodic_x); };
    const auto row = [&](int cell) { return place(cell, ground_.ny, ground_.periodic_y); };
    return cover(column(x - 1), y) > 0 || cover(column(x + 1), y) > 0 || cover(x, row(y - 1)) > 0 ||
           cover(x, row(y + 1)) > 0;
}

void Plants::find_cover() {
    for (std::size_t cell = 0; cell < cover_.size(); ++cell) {
        const std::int64_t both =
            species_[0].cover.values()[cell] + species_[1].cover.values()[cell];
        cover_.values()[cell] = in_part(std::min(both, whole_cover));
    }
}

Grid Plants::angles() const {
    Grid angles(ground_.nx, ground_.ny);
    std::ranges::transform(cover_.values(), angles.values().begin(), [&](double cover) {
        return bare_angle_ + (plant_angle_ - bare_angle_) * std::min(cover / steep_cover, 1.0);
    });
    return angles;
}

Grid Plants::in_parts(const FixedPointGrid& cover) {
    Grid parts(cover.nx(), cover.ny());
    std::ranges::transform(cover.values(), parts.values().begin(), in_part);
    return parts;
}

void Plants::serialise(StateArchive& archive) {
    archive.values("grass", species_[0].cover.values());
    archive.values("shrubs", species_[1].cover.values());
    archive.values("surface_at_growth", surface_at_last_growth_.values());
    archive.value("time_of_growth", time_of_last_growth_);
    for (const Species& species : species_) {
        for (const std::int64_t cover : species.cover.values()) {
            if (cover < 0 || cover > whole_cover)
                archive.refuse("it has a plant cover outside 0 to 1");
        }
    }
    find_cover();
}

}  // namespace fumon
