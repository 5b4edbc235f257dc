#include "models/water/sediment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double stable_diffusion_number =
    0.4;  // D dt (1/dx² + 1/dy²) of an explicit turn: 0.5 is the limit
constexpr double most_turns = 10000;

}  // namespace

Sediment::Sediment(const GullyParameters& parameters, const WaterDomain& domain, int nx, int ny,
                   WorkerPool& pool)
    : transport_(parameters.transport),
      steep_(parameters.relief == Relief::steep),
      downhill_(steep_ && parameters.transport != SedimentTransport::as_printed),
      diffusion_rate_(parameters.bed_diffusion.value),
      law_{parameters.transport_factor.value,
           parameters.stress_factor,
           parameters.critical_stress,
           parameters.transport_exponent,
           parameters.velocity_exponent,
           parameters.slope_exponent,
           domain.slope,
           domain.slope_x,
           0.5 / domain.dx,
           0.5 / domain.dy},
      domain_(domain),
      nx_(nx),
      ny_(ny),
      pool_(pool),
      diffusion_(nx, ny, diffusion_rate_ / (domain.dx * domain.dx),
                 diffusion_rate_ / (domain.dy * domain.dy), domain.edges_x == EdgeKind::periodic,
                 domain.edges_y == EdgeKind::periodic, pool),
      row_changes_(static_cast<std::size_t>(ny)) {
    const double most =
        most_turns * stable_diffusion_number /
        (parameters.time_step * (1.0 / (domain.dx * domain.dx) + 1.0 / (domain.dy * domain.dy)));
    if (!domain.nodata.empty() && diffusion_rate_ > most) {
        throw KeyError(
            "model.bed_diffusion",
            fmt::format("model.bed_diffusion is {:.4g} m^2/s, too fast for steps of "
                        "{:.4g} s on a bed with cells without data; take at most {:.3g}, "
                        "or bed.nodata = \"fill\"",
                        diffusion_rate_, parameters.time_step, most));
    }
    if (!domain.nodata.empty()) change_ = Grid(nx, ny);
    if (transport_ == SedimentTransport::as_printed ||
        transport_ == SedimentTransport::conservative) {
        flux_x_ = Grid(nx, ny);
        flux_y_ = Grid(nx, ny);
    }
    if (downhill_ && transport_ == SedimentTransport::conservative) find_rim();
}

void Sediment::find_rim() {
    rim_ = Mask(nx_, ny_);
    const auto outside = [&](int x, int y) {
        if (domain_.edges_x == EdgeKind::periodic) x = (x + nx_) % nx_;
        if (domain_.edges_y == EdgeKind::periodic) y = (y + ny_) % ny_;
        if (x < 0 || x >= nx_) return domain_.edges_x == EdgeKind::open;
        if (y < 0 || y >= ny_) return domain_.edges_y == EdgeKind::open;
        return !domain_.nodata.empty() && domain_.nodata(x, y) != 0;
    };
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const bool beside =
                outside(x - 1, y) || outside(x + 1, y) || outside(x, y - 1) || outside(x, y + 1);
            rim_(x, y) = beside ? 1 : 0;
        }
    }
}

void Sediment::advance(Grid& bed, const Water& water, double dt) {
    if (transport_ == SedimentTransport::none) return;
    if (transport_ == SedimentTransport::loads && diffusion_rate_ == 0.0) return;
    if (!flux_x_.empty()) find_fluxes(bed, water);
    const bool masked = !domain_.nodata.empty();
    diffusion_.prepare(dt);
    pool_.for_ranges(ny_, [&](int begin, int end) {
        Scratch scratch(nx_);
        for (int y = begin; masked && y < end; ++y) {
            throw_if_cancelled();
            transport_row(bed, water, dt, y, scratch, change_.row(y).data());
        }
        for (int from = begin; !masked && from < end; from += BedDiffusion::rows_at_once) {
            throw_if_cancelled();
            const int to = std::min(from + BedDiffusion::rows_at_once, end);
            for (int y = from; y < to; ++y)
                transport_row(bed, water, dt, y, scratch, scratch.changes.row(y - from).data());
            diffusion_.first_half(bed, scratch.changes, from, to);
        }
    });
    for (const double change : row_changes_) changed_.add(change);
    if (masked) {
        diffuse_masked(bed, dt);
    } else {
        diffusion_.second_half(bed);
    }
}

/// Of all cells, where the change of one depends on the fluxes of others.
void Sediment::find_fluxes(const Grid& bed, const Water& water) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        Scratch scratch(nx_);
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            flux_row(bed, water, y, scratch);
            sediment::direct_row(scratch.flux.data(), water.velocity_x.row(y).data(),
                                 water.velocity_y.row(y).data(), nx_, flux_x_.row(y).data(),
                                 flux_y_.row(y).data());
            if (downhill_) hold_at_walls(y);
        }
    });
}

/// |q_s| of a row into the scratch, and downhill the drops.
void Sediment::flux_row(const Grid& bed, const Water& water, int y, Scratch& scratch) {
    if (downhill_) {
        constexpr GhostValue same = GhostValue::same;
        sediment::downhill_row(law_, bed.row(y).data(),
                               scratch.bed.of(bed, domain_, y, same, same, same), nx_,
                               scratch.flux.data(), scratch.drop.data());
    } else {
        constexpr GhostValue line = GhostValue::extrapolated;
        sediment::steepness_row(law_, scratch.bed.of(bed, domain_, y, line, line, line), nx_,
                                scratch.flux.data());
    }
    sediment::flux_row(law_, water.velocity_x.row(y).data(), water.velocity_y.row(y).data(), nx_,
                       scratch.flux.data());
}

/// Takes away what would pass a wall.
void Sediment::hold_at_walls(int y) {
    if (domain_.edges_x == EdgeKind::wall) {
        flux_x_(0, y) = std::max(flux_x_(0, y), 0.0);
        flux_x_(nx_ - 1, y) = std::min(flux_x_(nx_ - 1, y), 0.0);
    }
    if (domain_.edges_y != EdgeKind::wall) return;
    for (double& flux : flux_y_.row(y)) {
        if (y == 0) flux = std::max(flux, 0.0);
        if (y == ny_ - 1) flux = std::min(flux, 0.0);
    }
}

void Sediment::transport_row(const Grid& bed, const Water& water, double dt, int y,
                             Scratch& scratch, double* change) {
    constexpr GhostValue same = GhostValue::same;
    switch (transport_) {
        case SedimentTransport::none:
            break;
        case SedimentTransport::loads:
            std::fill_n(change, nx_, 0.0);
            break;
        case SedimentTransport::incision:
            flux_row(bed, water, y, scratch);
            if (downhill_) {
                sediment::incise_downhill_row(scratch.flux.data(), scratch.drop.data(), dt, nx_,
                                              change);
            } else {
                sediment::incise_row(scratch.flux.data(), dt, nx_, change);
            }
            break;
        case SedimentTransport::as_printed:
            sediment::sum_row(law_, scratch.along_x.of(flux_x_, domain_, y, same, same, same),
                              scratch.along_y.of(flux_y_, domain_, y, same, same, same), dt, nx_,
                              change);
            if (steep_) {
                sediment::hold_between_neighbours(law_, bed.row(y).data(),
                                                  scratch.bed.of(bed, domain_, y, same, same, same),
                                                  nx_, change);
            }
            break;
        case SedimentTransport::conservative:
            settle_row(bed, dt, y, scratch, change);
            break;
    }
    if (!domain_.nodata.empty()) {
        for (int x = 0; x < nx_; ++x) {
            if (domain_.nodata(x, y) != 0) change[x] = 0.0;
        }
    }
    row_changes_[static_cast<std::size_t>(y)] = sediment::row_sum(change, nx_);
}

/// What conservative transport changes in a row.
void Sediment::settle_row(const Grid& bed, double dt, int y, Scratch& scratch, double* change) {
    constexpr GhostValue same = GhostValue::same;
    const auto conserved = [](EdgeKind edge) {
        return edge == EdgeKind::wall ? GhostValue::opposite : GhostValue::same;
    };
    const sediment::Sides along_x =
        scratch.along_x.of(flux_x_, domain_, y, conserved(domain_.edges_x), same, same);
    const sediment::Sides along_y =
        scratch.along_y.of(flux_y_, domain_, y, same, conserved(domain_.edges_y), same);
    if (!downhill_) {
        sediment::diverge_row(law_, along_x, along_y, dt, nx_, change);
        return;
    }
    sediment::settle_downhill_row(
        law_, bed.row(y).data(), scratch.bed.of(bed, domain_, y, same, same, same),
        flux_x_.row(y).data(), along_x, flux_y_.row(y).data(), along_y, dt, nx_, change);
    for (int x = 0; x < nx_; ++x) {
        if (rim_(x, y) != 0) change[x] = std::min(change[x], 0.0);
    }
}

/// Explicit, in as many turns as that takes: nothing crosses the rim of cells without data.
void Sediment::diffuse_masked(Grid& bed, double dt) {
    const double per_x = diffusion_rate_ * dt / (domain_.dx * domain_.dx);
    const double per_y = diffusion_rate_ * dt / (domain_.dy * domain_.dy);
    const int turns =
        std::max(1, static_cast<int>(std::ceil((per_x + per_y) / stable_diffusion_number)));
    for (std::size_t cell = 0; cell < bed.size(); ++cell)
        bed.values()[cell] += change_.values()[cell];
    for (int turn = 0; turn < turns; ++turn) {
        pool_.for_ranges(ny_, [&](int begin, int end) {
            RowNeighbours scratch(nx_);
            constexpr GhostValue same = GhostValue::same;
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                const sediment::Sides sides = scratch.of(bed, domain_, y, same, same, same);
                for (int x = 0; x < nx_; ++x) {
                    const double here = bed(x, y);
                    const double gain = per_x * ((sides.west[x] - here) + (sides.east[x] - here)) +
                                        per_y * ((sides.south[x] - here) + (sides.north[x] - here));
                    change_(x, y) = domain_.nodata(x, y) != 0 ? 0.0 : gain / turns;
                }
            }
        });
        for (std::size_t cell = 0; cell < bed.size(); ++cell)
            bed.values()[cell] += change_.values()[cell];
    }
}

}  // namespace fumon
