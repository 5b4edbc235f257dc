#include "examination/first_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fumon::examination {

FirstOrder::FirstOrder(const GullyParameters& parameters, const WaterDomain& domain, Grid bed,
                       Water water)
    : parameters_(parameters),
      domain_(domain),
      bed_(std::move(bed)),
      water_(std::move(water)),
      next_(water_),
      edges_(domain_, bed_.nx(), bed_.ny()) {}

double FirstOrder::step_at_courant_one() const {
    double most = 0.0;
    for (std::size_t k = 0; k < bed_.size(); ++k) {
        const double c = std::sqrt(parameters_.gravity * water_.depth.values()[k]);
        most = std::max(most, (std::fabs(water_.velocity_x.values()[k]) + c) / domain_.dx +
                                  (std::fabs(water_.velocity_y.values()[k]) + c) / domain_.dy);
    }
    const double of_edges = edge_step_at_courant_one(domain_, 0.0, bed_, parameters_.gravity);
    return std::min(most > 0.0 ? 1.0 / most : std::numeric_limits<double>::infinity(), of_edges);
}

FirstOrder::Cell FirstOrder::cell(int x, int y, bool across_x) const {
    const double u = water_.velocity_x(x, y);
    const double v = water_.velocity_y(x, y);
    return {water_.depth(x, y), across_x ? u : v, across_x ? v : u, bed_(x, y)};
}

/// Momentum without each side's own pressure, as FiniteVolumeScheme has it.
FirstOrder::Flux FirstOrder::face(const Cell& left, const Cell& right) const {
    const double g = parameters_.gravity;
    const double z = std::max(left.z, right.z);
    const double hl = std::max(left.h + left.z - z, 0.0);
    const double hr = std::max(right.h + right.z - z, 0.0);
    if (hl == 0.0 && hr == 0.0) return {};
    const double cl = std::sqrt(g * hl);
    const double cr = std::sqrt(g * hr);
    const double slow = std::min({left.u - cl, right.u - cr, 0.0});
    const double fast = std::max({left.u + cl, right.u + cr, 0.0});
    const auto mixed = [&](double fl, double fr, double ql, double qr) {
        return (fast * fl - slow * fr + slow * fast * (qr - ql)) / (fast - slow);
    };
    const double ql = hl * left.u;
    const double qr = hr * right.u;
    const double mass = mixed(ql, qr, hl, hr);
    const double momentum =
        mixed(ql * left.u + 0.5 * g * hl * hl, qr * right.u + 0.5 * g * hr * hr, ql, qr);
    return {mass, momentum - 0.5 * g * hl * hl, momentum - 0.5 * g * hr * hr,
            mass > 0.0 ? mass * left.v : mass * right.v};
}

FirstOrder::Flux FirstOrder::at_edge(const Cell& inside, GridSide side, int cell) const {
    const bool low = side == GridSide::west || side == GridSide::south;
    const double sign = low ? -1.0 : 1.0;
    if (edges_.flows(side, cell)) {
        const EdgeFlux flux = edges_.flux(
            side, cell, {inside.h, sign * inside.u, inside.v, inside.z}, parameters_.gravity);
        const double change = flux.momentum - 0.5 * parameters_.gravity * inside.h * inside.h;
        return {sign * flux.mass, change, change, sign * flux.along};
    }
    const bool open = edges_.kind(side, cell) == EdgeKind::open;
    const Cell beyond{open ? 0.0 : inside.h, open ? 0.0 : -inside.u, inside.v, inside.z};
    return low ? face(beyond, inside) : face(inside, beyond);
}

FirstOrder::Flux FirstOrder::face_west_of(int x, int y) const {
    const int nx = bed_.nx();
    if (domain_.edges_x == EdgeKind::periodic)
        return face(cell((x + nx - 1) % nx, y, true), cell(x % nx, y, true));
    if (x == 0) return at_edge(cell(0, y, true), GridSide::west, y);
    if (x == nx) return at_edge(cell(nx - 1, y, true), GridSide::east, y);
    return face(cell(x - 1, y, true), cell(x, y, true));
}

FirstOrder::Flux FirstOrder::face_south_of(int x, int y) const {
    const int ny = bed_.ny();
    if (domain_.edges_y == EdgeKind::periodic)
        return face(cell(x, (y + ny - 1) % ny, false), cell(x, y % ny, false));
    if (y == 0) return at_edge(cell(x, 0, false), GridSide::south, x);
    if (y == ny) return at_edge(cell(x, ny - 1, false), GridSide::north, x);
    return face(cell(x, y - 1, false), cell(x, y, false));
}

void FirstOrder::advance(double time, double dt) {
    edges_.set_time(time);
    const double g = parameters_.gravity;
    const double dt_dx = dt / domain_.dx;
    const double dt_dy = dt / domain_.dy;
    for (int y = 0; y < bed_.ny(); ++y) {
        for (int x = 0; x < bed_.nx(); ++x) {
            const Flux west = face_west_of(x, y);
            const Flux east = face_west_of(x + 1, y);
            const Flux south = face_south_of(x, y);
            const Flux north = face_south_of(x, y + 1);
            const double h = water_.depth(x, y);
            const double h1 =
                std::max(h - dt_dx * (east.mass - west.mass) - dt_dy * (north.mass - south.mass) +
                             dt * parameters_.rain / 3.6e6,
                         0.0);
            const double qx = h * water_.velocity_x(x, y) - dt_dx * (east.left - west.right) -
                              dt_dy * (north.along - south.along);
            const double qy = h * water_.velocity_y(x, y) - dt_dy * (north.left - south.right) -
                              dt_dx * (east.along - west.along);
            const bool wet = h1 > 1e-9;
            double u = wet ? qx / h1 : 0.0;
            double v = wet ? qy / h1 : 0.0;
            double friction = constant_friction(parameters_);
            if (wet && parameters_.friction == FrictionLaw::manning)
                friction = g * parameters_.manning * parameters_.manning / std::cbrt(h1);
            if (wet && friction > 0.0) {
                const double drag = 4.0 * dt * friction * std::hypot(u, v) / h1;
                const double kept = 2.0 / (1.0 + std::sqrt(1.0 + drag));
                u *= kept;
                v *= kept;
            }
            next_.depth(x, y) = h1;
            next_.velocity_x(x, y) = u;
            next_.velocity_y(x, y) = v;
        }
    }
    std::swap(water_, next_);
}

}  // namespace fumon::examination
