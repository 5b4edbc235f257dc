#include "models/dunes/transport/continuous_transport.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/cancellation.h"
#include "base/worker_pool.h"
#include "models/dunes/plants/plant_shelter.h"
#include "models/dunes/plants/plants.h"
#include "models/dunes/transport/kernels/drift_vectors.h"

namespace fumon {

namespace {

/// Sand this thick lets hops end as on sand, thinner sand less so. Metres.
constexpr double full_cover = 0.01;

}  // namespace

ContinuousTransport::ContinuousTransport(const DunesParameters& parameters,
                                         const DuneGround& ground, double time_step,
                                         WorkerPool& pool)
    : parameters_(parameters),
      ground_(ground),
      drift_(units_per_metre * parameters.flux * time_step),
      pool_(pool),
      drift_x_(parameters.slope_drift * parameters.flux * time_step / (ground.dx * ground.dx)),
      drift_y_(parameters.slope_drift * parameters.flux * time_step / (ground.dy * ground.dy)),
      saltation_(parameters, ground, pool),
      landed_(parameters.rock_wear > 0.0 ? FixedPointGrid(ground.nx, ground.ny) : FixedPointGrid()),
      after_(ground.nx, ground.ny) {}

void ContinuousTransport::step(DuneBed& bed, const WindOverBed& wind) {
    hops_ = saturation_hops(parameters_, ground_, wind.blowing.x, wind.blowing.y);
    const double layer = layer_of(wind.blowing);
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            lift(bed, wind, layer, y);
            if (!landed_.empty()) std::ranges::fill(landed_.row(y), 0);
        }
    });
    const auto influx = static_cast<std::int64_t>(
        layer * parameters_.influx / (hops_.landing * parameters_.deposit_on_sand) / hops_.moves);
    for (int move = 1; move <= hops_.moves; ++move) {
        const bool last = move == hops_.moves;
        saltation_.hop(bed, wind, hops_);
        saltation_.add_influx(bed, wind.blowing, influx);
        pool_.for_ranges(ground_.ny, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                if (last) drift_down(bed, wind, y);
                deposit(last ? after_ : bed.surface, bed, wind, y);
            }
        });
    }
    std::swap(bed.surface, after_);
}

double ContinuousTransport::layer_of(const BlowingWind& wind) const {
    return drift_ * (hops_.landing * parameters_.deposit_on_sand) / hops_.length * wind.strength;
}

void ContinuousTransport::lift(DuneBed& bed, const WindOverBed& wind, double layer, int y) const {
    const auto surface = bed.surface.row(y);
    const auto rock = bed.rock.row(y);
    const auto moving = bed.moving.row(y);
    if (wind.plants == nullptr && wind.sheltered == nullptr && wind.before_walls == nullptr) {
        drift_vectors::lift(surface.size(), layer, greatest_lift, wind.shade.row(y).data(),
                            wind.shear != nullptr ? wind.shear->row(y).data() : nullptr,
                            rock.data(), surface.data(), moving.data());
        return;
    }
    for (std::size_t x = 0; x < surface.size(); ++x) {
        const double factor = lift_factor(wind, static_cast<int>(x), y);
        const auto wanted = static_cast<std::int64_t>(layer * factor);
        const std::int64_t lifted = std::min(wanted, surface[x] - rock[x]);
        surface[x] -= lifted;
        moving[x] += lifted;
    }
}

/// What neighbours give one another, seen alike from both sides.
void ContinuousTransport::drift_down(const DuneBed& bed, const WindOverBed& wind, int y) {
    const auto given = [](std::int64_t from, std::int64_t rock, std::int64_t to, double share) {
        const auto wanted = static_cast<std::int64_t>(share * static_cast<double>(from - to));
        return std::min(wanted, (from - rock) / 4);
    };
    const auto drifting = [&](int x, int row) {
        if (wind.sheltered == nullptr) return 1.0;
        return PlantShelter::lifted_under(1.0, (*wind.sheltered)(x, row), wind.blowing);
    };
    const double share_x = drift_x_ * wind.blowing.strength;
    const double share_y = drift_y_ * wind.blowing.strength;
    const auto surface = bed.surface.row(y);
    const auto rock = bed.rock.row(y);
    const auto cell = [&](int x) {
        const std::int64_t here = surface[static_cast<std::size_t>(x)];
        const std::int64_t rock_here = rock[static_cast<std::size_t>(x)];
        const double from_here = drifting(x, y);
        const auto got = [&](int from_x, int from_y, double share) -> std::int64_t {
            const std::int64_t there = bed.surface(from_x, from_y);
            return there > here ? given(there, bed.rock(from_x, from_y), here,
                                        share * drifting(from_x, from_y))
                                : -given(here, rock_here, there, share * from_here);
        };
        std::int64_t change = 0;
        for (const int beside : {ground_.column(x - 1), ground_.column(x + 1)}) {
            if (beside >= 0) change += got(beside, y, share_x);
        }
        for (const int beside : {ground_.row(y - 1), ground_.row(y + 1)}) {
            if (beside >= 0) change += got(x, beside, share_y);
        }
        after_(x, y) = here + change;
    };
    const int south = ground_.row(y - 1);
    const int north = ground_.row(y + 1);
    const int last = ground_.nx - 1;
    if (wind.sheltered != nullptr || south < 0 || north < 0 || last < 2) {
        for (int x = 0; x <= last; ++x) cell(x);
        return;
    }
    cell(0);
    drift_vectors::drift_down(
        {surface.data(), rock.data(), bed.surface.row(south).data(), bed.rock.row(south).data(),
         bed.surface.row(north).data(), bed.rock.row(north).data()},
        1, static_cast<std::size_t>(last), share_x, share_y, after_.row(y).data());
    cell(last);
}

void ContinuousTransport::deposit(FixedPointGrid& on, DuneBed& bed, const WindOverBed& wind,
                                  int y) {
    constexpr double thickness = full_cover * units_per_metre;
    const auto surface = on.row(y);
    std::int64_t* landed = landed_.empty() ? nullptr : landed_.row(y).data();
    const auto rock = bed.rock.row(y);
    const auto moving = bed.moving.row(y);
    const auto arrived = saltation_.arrived().row(y);
    const auto shaded = wind.shade.row(y);
    const double on_rock = parameters_.deposit_on_rock;
    const double more_on_sand = parameters_.deposit_on_sand - on_rock;
    if (wind.plants == nullptr && wind.before_walls == nullptr) {
        drift_vectors::deposit(
            surface.size(), {on_rock, more_on_sand, 1.0 / thickness, hops_.landing}, shaded.data(),
            rock.data(), arrived.data(), surface.data(), moving.data(), landed);
        return;
    }
    for (std::size_t x = 0; x < surface.size(); ++x) {
        const auto sand = static_cast<double>(surface[x] - rock[x]);
        const double cover = std::min(sand * (1.0 / thickness), 1.0);
        double share = on_rock + more_on_sand * cover;
        if (wind.plants != nullptr) share += wind.plants->cover().row(y)[x] * (1.0 - share);
        if (wind.along_walls != nullptr) {
            const double u = wind.before_walls->row(y)[x];
            const double v = wind.along_walls->row(y)[x];
            const double still = std::max(shaded[x], 1.0 - std::sqrt(u * u + v * v));
            share = std::max(share, still * (1.0 - std::abs(v)));
        } else {
            if (wind.before_walls != nullptr)
                share = std::max(share, 1.0 - std::abs(wind.before_walls->row(y)[x]));
            share = std::max(shaded[x], share);
        }
        share *= hops_.landing;
        const auto stays = static_cast<std::int64_t>(share * static_cast<double>(arrived[x]));
        surface[x] += stays;
        moving[x] = arrived[x] - stays;
        if (landed != nullptr) landed[x] += arrived[x];
        arrived[x] = 0;
    }
}

}  // namespace fumon
