#include "models/water/sediment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/give_up.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double stable_turn = 0.4;  // D dt (1/dx² + 1/dy²) of an explicit turn: 0.5 is the limit
constexpr double most_turns = 10000;

}  // namespace

Sediment::Sediment(const GullyParameters& parameters, const WaterDomain& domain, int nx, int ny,
                   WorkerPool& pool)
    : transport_(parameters.transport),
      diffusion_rate_(parameters.bed_diffusion),
      law_{parameters.transport_factor,
           parameters.stress_factor,
           parameters.critical_stress,
           parameters.transport_exponent,
           parameters.velocity_exponent,
           parameters.slope_exponent,
           domain.slope,
           0.5 / domain.dx,
           0.5 / domain.dy},
      domain_(domain),
      nx_(nx),
      ny_(ny),
      pool_(pool),
      diffusion_(nx, ny, parameters.bed_diffusion / (domain.dx * domain.dx),
                 parameters.bed_diffusion / (domain.dy * domain.dy),
                 domain.edges_x == EdgeKind::periodic, domain.edges_y == EdgeKind::periodic, pool),
      change_(nx, ny),
      row_changes_(static_cast<std::size_t>(ny)) {
    const double most =
        most_turns * stable_turn /
        (parameters.time_step * (1.0 / (domain.dx * domain.dx) + 1.0 / (domain.dy * domain.dy)));
    if (!domain.nodata.empty() && diffusion_rate_ > most) {
        throw KeyError(
            "model.bed_diffusion",
            fmt::format("model.bed_diffusion is {:.4g} m^2/s, too fast for steps of "
                        "{:.4g} s on a bed with cells without data; take at most {:.3g}, "
                        "or bed.nodata = \"fill\"",
                        diffusion_rate_, parameters.time_step, most));
    }
    if (transport_ == SedimentTransport::as_printed ||
        transport_ == SedimentTransport::conservative) {
        flux_x_ = Grid(nx, ny);
        flux_y_ = Grid(nx, ny);
    }
}

void Sediment::advance(Grid& bed, const Water& water, double dt) {
    if (!flux_x_.empty()) find_fluxes(bed, water);
    const bool masked = !domain_.nodata.empty();
    diffusion_.prepare(dt);
    pool_.for_ranges(ny_, [&](int begin, int end) {
        RowSides sides_x(nx_);
        RowSides sides_y(nx_);
        std::vector<double> flux(static_cast<std::size_t>(nx_));
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            transport_row(bed, water, dt, y, sides_x, sides_y, flux);
        }
        if (!masked) diffusion_.first_half(bed, change_, begin, end);
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
        RowSides sides(nx_);
        std::vector<double> flux(static_cast<std::size_t>(nx_));
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            const double* u = water.velocity_x.row(y).data();
            const double* v = water.velocity_y.row(y).data();
            constexpr Beyond line = Beyond::on_the_line;
            sediment::flux_row(law_, sides.of(bed, domain_, y, line, line, line), u, v, nx_,
                               flux.data());
            sediment::direct_row(flux.data(), u, v, nx_, flux_x_.row(y).data(),
                                 flux_y_.row(y).data());
        }
    });
}

void Sediment::transport_row(const Grid& bed, const Water& water, double dt, int y,
                             RowSides& sides_x, RowSides& sides_y, std::vector<double>& flux) {
    double* change = change_.row(y).data();
    const auto conserved = [](EdgeKind edge) {
        return edge == EdgeKind::wall ? Beyond::opposite : Beyond::same;
    };
    constexpr Beyond line = Beyond::on_the_line;
    constexpr Beyond same = Beyond::same;
    switch (transport_) {
        case SedimentTransport::none:
            std::fill_n(change, nx_, 0.0);
            return;
        case SedimentTransport::incision:
            sediment::flux_row(law_, sides_x.of(bed, domain_, y, line, line, line),
                               water.velocity_x.row(y).data(), water.velocity_y.row(y).data(), nx_,
                               flux.data());
            sediment::incise_row(flux.data(), dt, nx_, change);
            break;
        case SedimentTransport::as_printed:
            sediment::sum_row(law_, sides_x.of(flux_x_, domain_, y, same, same, same),
                              sides_y.of(flux_y_, domain_, y, same, same, same), dt, nx_, change);
            break;
        case SedimentTransport::conservative:
            sediment::diverge_row(
                law_, sides_x.of(flux_x_, domain_, y, conserved(domain_.edges_x), same, same),
                sides_y.of(flux_y_, domain_, y, same, conserved(domain_.edges_y), same), dt, nx_,
                change);
            break;
    }
    if (!domain_.nodata.empty()) {
        for (int x = 0; x < nx_; ++x) {
            if (domain_.nodata(x, y) != 0) change[x] = 0.0;
        }
    }
    row_changes_[static_cast<std::size_t>(y)] = sediment::row_sum(change, nx_);
}

/// Explicit, in as many turns as that takes: nothing crosses the rim of cells without data.
void Sediment::diffuse_masked(Grid& bed, double dt) {
    const double per_x = diffusion_rate_ * dt / (domain_.dx * domain_.dx);
    const double per_y = diffusion_rate_ * dt / (domain_.dy * domain_.dy);
    const int turns = std::max(1, static_cast<int>(std::ceil((per_x + per_y) / stable_turn)));
    for (std::size_t cell = 0; cell < bed.size(); ++cell)
        bed.values()[cell] += change_.values()[cell];
    for (int turn = 0; turn < turns; ++turn) {
        pool_.for_ranges(ny_, [&](int begin, int end) {
            RowSides scratch(nx_);
            constexpr Beyond same = Beyond::same;
            for (int y = begin; y < end; ++y) {
                give_up_if_asked();
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
