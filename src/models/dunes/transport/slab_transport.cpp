#include "models/dunes/transport/slab_transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>

#include "base/cancellation.h"
#include "base/worker_pool.h"
#include "models/dunes/plants/plants.h"
#include "models/dunes/transport/saltation.h"

namespace fumon {

namespace {

/// Passes of avalanches after each sub-step but the last, after which they end: what slides on from
/// one to the next is less than what the next one's slabs bring.
constexpr int passes_between = 1;

/// Where a place along an axis lies in the grid; −1 beyond an open edge.
int cell_of(double place, int count, bool periodic) {
    const double cell = std::floor(place);
    if (cell >= 0.0 && cell < count) return static_cast<int>(cell);
    if (!periodic) return -1;
    const double round = cell - count * std::floor(cell / count);
    return std::min(static_cast<int>(round), count - 1);
}

}  // namespace

SlabTransport::SlabTransport(const DunesParameters& parameters, const DuneGround& ground,
                             double slab_height, const ShadowTangents& shadow, std::uint64_t seed,
                             WorkerPool& pool)
    : parameters_(parameters),
      ground_(ground),
      slab_(to_units(slab_height)),
      shadow_(shadow),
      seed_(seed),
      pool_(pool),
      change_(ground.nx, ground.ny),
      picks_(static_cast<std::size_t>(ground.ny)),
      lost_(static_cast<std::size_t>(ground.ny)) {}

double SlabTransport::held(double shade, int x, int y) const {
    if (plants_ == nullptr) return shade;
    return 1.0 - (1.0 - shade) * plants_->lifted(plants_->cover()(x, y));
}

void SlabTransport::step(DuneBed& bed, const BlowingWind& wind, const Plants* plants,
                         std::int64_t step, WindShadow& shadow, Avalanches& avalanches) {
    plants_ = plants;
    if (parameters_.speed_up == DuneSpeedUp::height) mean_ = mean_height(bed.surface);
    if (parameters_.order == SlabOrder::sequential) {
        step_in_sequence(bed, wind, step, avalanches);
    } else {
        step_in_parallel(bed, wind, step, shadow, avalanches);
    }
}

/// Hops from a place, in cells, until the slab comes to rest; false where it leaves over an open
/// edge.
template <class Shade>
bool SlabTransport::hop(const DuneBed& bed, const BlowingWind& wind, const Shade& shade,
                        double from_x, double from_y, RandomStream& stream, Cell& place) const {
    const double cells_x = parameters_.hop_length * wind.x / ground_.dx;
    const double cells_y = parameters_.hop_length * wind.y / ground_.dy;
    double x = from_x + stream.uniform();
    double y = from_y + stream.uniform();
    double factor = 1.0;
    while (true) {
        if (parameters_.speed_up == DuneSpeedUp::height) {
            const int at_x = cell_of(x, ground_.nx, ground_.periodic_x);
            const int at_y = cell_of(y, ground_.ny, ground_.periodic_y);
            if (at_x >= 0 && at_y >= 0)
                factor = hop_factor(parameters_, to_metres(bed.surface(at_x, at_y)) - mean_);
        }
        x += factor * cells_x;
        y += factor * cells_y;
        place.x = cell_of(x, ground_.nx, ground_.periodic_x);
        place.y = cell_of(y, ground_.ny, ground_.periodic_y);
        if (place.x < 0 || place.y < 0) return false;
        const bool on_sand =
            bed.surface(place.x, place.y) > rock_range_.at(bed.rock, place.x, place.y);
        double of_ground = on_sand ? parameters_.deposit_on_sand : parameters_.deposit_on_rock;
        if (plants_ != nullptr) of_ground += plants_->cover()(place.x, place.y) * (1.0 - of_ground);
        if (stream.uniform() < std::max(of_ground, shade(place.x, place.y))) return true;
    }
}

std::int64_t SlabTransport::pick_row(const DuneBed& bed, const BlowingWind& wind, const Grid& shade,
                                     int y, RandomStream& stream, Share& share) {
    const auto shade_at = [&](int x, int row) { return shade(x, row); };
    const std::int64_t picks = picks_[static_cast<std::size_t>(y)];
    const int next = y + 1 < share.end ? y + 1 : y;
    const int lines_a_pick = static_cast<int>(ground_.nx / cells_of_cache_line / (picks + 1)) + 1;
    // Cells of the next row are fetched while a row's cells are picked, which come in no order that
    // the processor would foresee.
    int fetched = 0;
    std::int64_t lost = 0;
    for (std::int64_t pick = 0; pick < picks; ++pick) {
        const int fetch = std::min(fetched + lines_a_pick * cells_of_cache_line, ground_.nx);
        for (; fetched < fetch; fetched += cells_of_cache_line) {
            __builtin_prefetch(&bed.surface(fetched, next));
            if (!rock_range_.is_level(fetched, next)) __builtin_prefetch(&bed.rock(fetched, next));
            __builtin_prefetch(&shade(fetched, next));
            __builtin_prefetch(&change_(fetched, next), 1);
        }
        const auto x = static_cast<int>(stream.below(static_cast<std::uint32_t>(ground_.nx)));
        const double shaded = shade(x, y);
        const double chance = stream.uniform();
        std::int64_t& taken = share.taken[static_cast<std::size_t>(x)];
        const std::int64_t left = bed.surface(x, y) - rock_range_.at(bed.rock, x, y) - taken;
        if (left <= 0 || chance < held(shaded, x, y)) continue;
        const std::int64_t slab = std::min(slab_, left);
        taken += slab;
        share.picked.push_back(x);
        change_(x, y) -= slab;
        Cell place;
        if (!hop(bed, wind, shade_at, x, y, stream, place)) {
            lost += slab;
        } else if (place.y >= share.begin && place.y < share.end) {
            change_(place.x, place.y) += slab;
        } else {
            share.beyond.push_back({place, slab});
        }
    }
    for (const int x : share.picked) share.taken[static_cast<std::size_t>(x)] = 0;
    share.picked.clear();
    return lost;
}

/// Slabs that come in over open edges in a sub-step: so many as leave flat ground that drifts at
/// the share `influx` of saturation.
std::int64_t SlabTransport::add_influx(const DuneBed& bed, const BlowingWind& wind,
                                       const Grid& shade, std::int64_t substep) {
    const auto shade_at = [&](int x, int y) { return shade(x, y); };
    const double hop_x = std::abs(parameters_.hop_length * wind.x / ground_.dx);
    const double hop_y = std::abs(parameters_.hop_length * wind.y / ground_.dy);
    const double drift = parameters_.influx / parameters_.deposit_on_sand /
                         static_cast<double>(parameters_.substeps);
    RandomStream stream(seed_, 0, substep, Purpose::influx);
    std::int64_t came = 0;
    const auto over_edge = [&](double slabs, const auto& start) {
        const double wanted = slabs + stream.uniform();
        for (auto left = static_cast<std::int64_t>(wanted); left > 0; --left) {
            const auto [x, y] = start();
            Cell place;
            if (!hop(bed, wind, shade_at, x, y, stream, place)) continue;
            change_(place.x, place.y) += slab_;
            came += slab_;
        }
    };
    if (!ground_.periodic_x && hop_x > 0.0) {
        over_edge(drift * hop_x * ground_.ny, [&] {
            const double back = hop_x * stream.uniform();
            const double x = wind.x > 0.0 ? -back : ground_.nx - 1 + back;
            return std::array{
                x, static_cast<double>(stream.below(static_cast<std::uint32_t>(ground_.ny)))};
        });
    }
    if (!ground_.periodic_y && hop_y > 0.0) {
        over_edge(drift * hop_y * ground_.nx, [&] {
            const double back = hop_y * stream.uniform();
            const double y = wind.y > 0.0 ? -back : ground_.ny - 1 + back;
            return std::array{
                static_cast<double>(stream.below(static_cast<std::uint32_t>(ground_.nx))), y};
        });
    }
    return came;
}

void SlabTransport::step_in_parallel(DuneBed& bed, const BlowingWind& wind, std::int64_t step,
                                     WindShadow& shadow, Avalanches& avalanches) {
    const auto cells = static_cast<std::int64_t>(bed.surface.size());
    const std::int64_t substeps = parameters_.substeps;
    rock_range_.find(bed.rock, pool_);
    for (std::int64_t k = 0; k < substeps; ++k) {
        const std::int64_t substep = step * substeps + k;
        shadow.cast(bed.surface, wind, shadow_, WindShadow::Find::shade);
        RandomStream shares(seed_, 0, substep, Purpose::picks_per_row);
        multinomial_equal(shares, (k + 1) * cells / substeps - k * cells / substeps, picks_);
        std::mutex joining;
        std::vector<Landing> beyond;
        pool_.for_ranges(ground_.ny, [&](int begin, int end) {
            Share share{begin,
                        end,
                        std::vector<std::int64_t>(static_cast<std::size_t>(ground_.nx)),
                        {},
                        {}};
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                RandomStream stream(seed_, static_cast<std::uint32_t>(y), substep, Purpose::picks);
                lost_[static_cast<std::size_t>(y)] =
                    pick_row(bed, wind, shadow.shade(), y, stream, share);
            }
            const std::scoped_lock lock(joining);
            beyond.insert(beyond.end(), share.beyond.begin(), share.beyond.end());
        });
        for (const auto& [place, slab] : beyond) change_(place.x, place.y) += slab;
        bed.outflow += std::accumulate(lost_.begin(), lost_.end(), std::int64_t{0});
        if (parameters_.influx > 0.0) bed.inflow += add_influx(bed, wind, shadow.shade(), substep);
        const auto land = [&](int y) {
            const auto changes = change_.row(y);
            std::ranges::transform(bed.surface.row(y), changes, bed.surface.row(y).begin(),
                                   std::plus<>());
            std::ranges::fill(changes, 0);
        };
        const bool last = k + 1 == substeps;
        const int most =
            last ? avalanches.most_passes : std::min(passes_between, avalanches.most_passes);
        using RestCheck = SlopeRelaxation::RestCheck;
        const auto outcome =
            avalanches.slopes.relax(bed.surface, {bed.rock, &rock_range_}, most,
                                    last ? RestCheck::required : RestCheck::skipped, land);
        avalanches.passes = std::max(avalanches.passes, outcome.passes);
        if (last) avalanches.at_rest = outcome.at_rest;
    }
}

/// The shadow on one cell: the ground upwind, row by row along the wind, linear between cells.
double SlabTransport::marched_shade(const DuneBed& bed, const BlowingWind& wind, int x, int y,
                                    std::int64_t highest) const {
    const double cells_x = wind.x / ground_.dx;
    const double cells_y = wind.y / ground_.dy;
    const bool along_x = std::abs(cells_x) > std::abs(cells_y);
    const double along = std::abs(along_x ? cells_x : cells_y);
    const double shift = (along_x ? cells_y : cells_x) / along;
    const int way = (along_x ? cells_x : cells_y) > 0.0 ? 1 : -1;
    const int most = along_x ? ground_.nx : ground_.ny;
    const std::int64_t here = bed.surface(x, y);
    const double relief = to_metres(highest - here);
    double shade = 0.0;
    for (int n = 1; n <= most && shade < 1.0; ++n) {
        const double distance = n / along;
        if (relief <= shadow_.soft * distance) break;
        const double side = -shift * n;
        const double whole = std::floor(side);
        const double beyond = side - whole;
        const auto height = [&](double aside) {
            const double at_x = along_x ? x - way * n : x + aside;
            const double at_y = along_x ? y + aside : y - way * n;
            const int cell_x = cell_of(at_x, ground_.nx, ground_.periodic_x);
            const int cell_y = cell_of(at_y, ground_.ny, ground_.periodic_y);
            return cell_x < 0 || cell_y < 0 ? 0.0 : to_metres(bed.surface(cell_x, cell_y) - here);
        };
        const double rise = (1.0 - beyond) * height(whole) + beyond * height(whole + 1.0);
        constexpr double thinnest = 1e-9;
        const double room = std::max(shadow_.full - shadow_.soft, thinnest);
        shade = std::max(shade, std::min((rise / distance - shadow_.soft) / room, 1.0));
    }
    return shade;
}

void SlabTransport::step_in_sequence(DuneBed& bed, const BlowingWind& wind, std::int64_t step,
                                     Avalanches& avalanches) {
    rock_range_.find(bed.rock, pool_);
    RandomStream stream(seed_, 0, step, Purpose::picks);
    const auto cells = static_cast<std::uint32_t>(bed.surface.size());
    const auto nx = static_cast<std::uint32_t>(ground_.nx);
    const std::int64_t most_moves =
        static_cast<std::int64_t>(avalanches.most_passes) * static_cast<std::int64_t>(cells);
    std::int64_t highest = *std::ranges::max_element(bed.surface.values());
    const auto shade_at = [&](int x, int y) { return marched_shade(bed, wind, x, y, highest); };
    const auto settle = [&](std::size_t cell) {
        const std::array one{cell};
        if (!avalanches.slopes.relax_near(bed.surface, bed.rock, one, most_moves))
            avalanches.at_rest = false;
    };
    if (step == 0) {
        const auto outcome = avalanches.slopes.relax(bed.surface, bed.rock, avalanches.most_passes);
        avalanches.at_rest = outcome.at_rest;
    }
    for (std::uint32_t pick = 0; pick < cells; ++pick) {
        if (pick % nx == 0) throw_if_cancelled();
        const std::uint32_t cell = stream.below(cells);
        const auto x = static_cast<int>(cell % nx);
        const auto y = static_cast<int>(cell / nx);
        const double chance = stream.uniform();
        const std::int64_t slab = std::min(slab_, bed.surface(x, y) - bed.rock(x, y));
        if (slab <= 0 || chance < held(shade_at(x, y), x, y)) continue;
        bed.surface(x, y) -= slab;
        Cell place;
        const bool rests = hop(bed, wind, shade_at, x, y, stream, place);
        settle(cell);
        if (!rests) {
            bed.outflow += slab;
            continue;
        }
        bed.surface(place.x, place.y) += slab;
        highest = std::max(highest, bed.surface(place.x, place.y));
        settle(static_cast<std::size_t>(place.y) * nx + static_cast<std::size_t>(place.x));
    }
}

}  // namespace fumon
