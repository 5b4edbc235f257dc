#include "plain/finite_volume_plain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fumon::plain {

namespace {

constexpr double gravity = 9.8;
constexpr double friction = 0.01;
constexpr double dx = 1.0;
constexpr double dy = 1.0;
constexpr double dry_depth = 1e-9;

/// Half of the limited slope between differences to either side.
double half_slope(double back, double forward, double bound) {
    if (!(back * forward > 0.0)) return 0.0;
    const double middle = 0.25 * (back + forward);
    if (back > 0.0) return std::min(bound * std::min(back, forward), middle);
    return std::max(bound * std::max(back, forward), middle);
}

double minmod_half(double one, double other) {
    if (!(one * other > 0.0)) return 0.0;
    return 0.5 * (one > 0.0 ? std::min(one, other) : std::max(one, other));
}

/// A cell's side of a face.
struct Side {
    double depth, surface, normal, transverse, bed;
};

struct Flux {
    double mass, left, right, transverse;
};

Flux through_face(const Side& l, const Side& r) {
    const double bed_l = l.surface - l.depth;
    const double bed_r = r.surface - r.depth;
    const double step = std::min(std::max(bed_l, bed_r), std::min(l.surface, r.surface));
    const double above_l = l.surface - step;
    const double above_r = r.surface - step;
    const double hl = std::min(above_l, l.depth);
    const double hr = std::min(above_r, r.depth);
    const double cl = std::sqrt(gravity * hl);
    const double cr = std::sqrt(gravity * hr);
    const double ul = hl > 0.0 ? l.normal : r.normal - 2.0 * cr;
    const double ur = hr > 0.0 ? r.normal : l.normal + 2.0 * cl;
    const double u_star = 0.5 * (ul + ur) + (cl - cr);
    const double c_star = 0.5 * (cl + cr) + 0.25 * (ul - ur);
    const double slowest = std::min(std::min(ul - cl, u_star - c_star), 0.0);
    const double quickest = std::max(std::max(ur + cr, u_star + c_star), 0.0);
    const double share = 1.0 / std::max(quickest - slowest, 1e-300);
    const double ql = hl * ul;
    const double qr = hr * ur;
    const double both = slowest * quickest;
    const double mass = ((quickest * ql - slowest * qr) + both * (hr - hl)) * share;
    const double carried = (quickest * (ql * ul) - slowest * (qr * ur)) + both * (qr - ql);
    const double pressure_rise = 0.5 * gravity * ((hr - hl) * (hr + hl));
    const double fall_l = 0.5 * gravity * ((l.depth + hl) * (hl - above_l));
    const double fall_r = 0.5 * gravity * ((r.depth + hr) * (hr - above_r));
    const double rise = r.bed - l.bed;  // of the bed by its own slopes
    const double blocked_l = std::max(std::min((l.depth - hl) - hl, rise), 0.0);
    const double blocked_r = std::max(std::min((r.depth - hr) - hr, 0.0 - rise), 0.0);
    const double against_l = std::max(l.normal, 0.0);
    const double against_r = std::min(r.normal, 0.0);
    const double stopped_l = blocked_l * (against_l * against_l);
    const double stopped_r = blocked_r * (against_r * against_r);
    return {mass, (carried - slowest * pressure_rise) * share + (fall_l + stopped_l),
            (carried - quickest * pressure_rise) * share + (fall_r + stopped_r),
            std::max(mass, 0.0) * l.transverse + std::min(mass, 0.0) * r.transverse};
}

}  // namespace

FiniteVolume::FiniteVolume(Grid bed, double slope, double depth, double speed)
    : n_(bed.nx()), slope_(slope), z_(std::move(bed)) {
    const Grid empty(n_, n_);
    now_ = {Grid(n_, n_, depth), empty, Grid(n_, n_, -speed)};
    between_ = {empty, empty, empty};
    along_x_ = along_y_ = {empty, empty, empty, empty, empty};
    east_ = north_ = {empty, empty, empty, empty};
    share_ = empty;
}

void FiniteVolume::step(double courant_number, double rain) {
    const double dt = courant_number * longest_step();
    update(now_, nullptr, dt, rain, between_);
    update(between_, &now_, dt, rain, now_);
}

double FiniteVolume::longest_step() const {
    double most = 0.0;
    for (std::size_t i = 0; i < z_.size(); ++i) {
        const double c = std::sqrt(gravity * now_.h.values()[i]);
        most = std::max(most, (std::fabs(now_.u.values()[i]) + c) / dx +
                                  (std::fabs(now_.v.values()[i]) + c) / dy);
    }
    return 1.0 / most;
}

void FiniteVolume::compute_slopes(const Flow& f) {
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            const auto limit = [&](int xb, int yb, int xf, int yf, const Grid& normal,
                                   const Grid& transverse, Slopes& out, Grid& out_normal,
                                   Grid& out_transverse) {
                const double h = f.h(x, y);
                const double surface = h + z_(x, y);
                const double depth_back = h - f.h(xb, yb);
                const double depth_forward = f.h(xf, yf) - h;
                const double surface_back = surface - (f.h(xb, yb) + z_(xb, yb));
                const double surface_forward = (f.h(xf, yf) + z_(xf, yf)) - surface;
                const double shallowest = std::min(std::min(f.h(xb, yb), f.h(xf, yf)), h);
                const double bed_step = std::max(std::fabs(surface_back - depth_back),
                                                 std::fabs(surface_forward - depth_forward));
                const double bound = shallowest > bed_step ? 1.0 : 0.5;
                out.h(x, y) = half_slope(depth_back, depth_forward, bound);
                out.surface(x, y) = half_slope(surface_back, surface_forward, bound);
                out.bed(x, y) =
                    minmod_half(surface_back - depth_back, surface_forward - depth_forward);
                out_normal(x, y) =
                    half_slope(normal(x, y) - normal(xb, yb), normal(xf, yf) - normal(x, y), 1.0);
                out_transverse(x, y) = half_slope(transverse(x, y) - transverse(xb, yb),
                                                  transverse(xf, yf) - transverse(x, y), 1.0);
            };
            limit(before(x), y, after(x), y, f.u, f.v, along_x_, along_x_.u, along_x_.v);
            limit(x, before(y), x, after(y), f.v, f.u, along_y_, along_y_.v, along_y_.u);
        }
    }
}

void FiniteVolume::compute_fluxes(const Flow& f) {
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            const auto sides = [&](int xn, int yn, const Slopes& s, const Grid& normal,
                                   const Grid& transverse, const Grid& s_normal,
                                   const Grid& s_transverse) {
                const Side l{f.h(x, y) + s.h(x, y), (f.h(x, y) + z_(x, y)) + s.surface(x, y),
                             normal(x, y) + s_normal(x, y), transverse(x, y) + s_transverse(x, y),
                             ((f.h(x, y) + z_(x, y)) - f.h(x, y)) + s.bed(x, y)};
                const Side r{
                    f.h(xn, yn) - s.h(xn, yn), (f.h(xn, yn) + z_(xn, yn)) - s.surface(xn, yn),
                    normal(xn, yn) - s_normal(xn, yn), transverse(xn, yn) - s_transverse(xn, yn),
                    ((f.h(xn, yn) + z_(xn, yn)) - f.h(xn, yn)) - s.bed(xn, yn)};
                return through_face(l, r);
            };
            const auto put = [&](const Flux& flux, Fluxes& out) {
                out.mass(x, y) = flux.mass;
                out.left(x, y) = flux.left;
                out.right(x, y) = flux.right;
                out.transverse(x, y) = flux.transverse;
            };
            put(sides(after(x), y, along_x_, f.u, f.v, along_x_.u, along_x_.v), east_);
            put(sides(x, after(y), along_y_, f.v, f.u, along_y_.v, along_y_.u), north_);
        }
    }
}

/// To what the cells can pay.
void FiniteVolume::cut_fluxes(const Flow& f, double dt) {
    bool is_short = false;
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            const double out =
                dt / dx *
                    (std::max(east_.mass(x, y), 0.0) - std::min(east_.mass(before(x), y), 0.0)) +
                dt / dy *
                    (std::max(north_.mass(x, y), 0.0) - std::min(north_.mass(x, before(y)), 0.0));
            const bool asks_more = out > f.h(x, y);
            is_short = is_short || asks_more;
            share_(x, y) = asks_more ? f.h(x, y) / out : 1.0;
        }
    }
    if (!is_short) return;
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            const auto cut = [&](Fluxes& flux, int xn, int yn) {
                const double share = flux.mass(x, y) > 0.0 ? share_(x, y) : share_(xn, yn);
                flux.mass(x, y) *= share;
                flux.left(x, y) *= share;
                flux.right(x, y) *= share;
                flux.transverse(x, y) *= share;
            };
            cut(east_, after(x), y);
            cut(north_, x, after(y));
        }
    }
}

void FiniteVolume::update(const Flow& from, const Flow* start, double dt, double rain, Flow& to) {
    compute_slopes(from);
    compute_fluxes(from);
    cut_fluxes(from, dt);
    const double dt_dx = dt / dx;
    const double dt_dy = dt / dy;
    for (int y = 0; y < n_; ++y) {
        const int ys = before(y);
        for (int x = 0; x < n_; ++x) {
            const int xw = before(x);
            const double h = from.h(x, y);
            const double weight = 2.0 * gravity * h;
            const double lost = dt_dx * (east_.mass(x, y) - east_.mass(xw, y)) +
                                dt_dy * (north_.mass(x, y) - north_.mass(x, ys));
            const double lost_x = dt_dx * ((east_.left(x, y) - east_.right(xw, y)) +
                                           weight * along_x_.surface(x, y)) +
                                  dt_dy * (north_.transverse(x, y) - north_.transverse(x, ys));
            const double lost_y = dt_dy * ((north_.left(x, y) - north_.right(x, ys)) +
                                           weight * along_y_.surface(x, y)) +
                                  dt_dx * (east_.transverse(x, y) - east_.transverse(xw, y));
            double h1 = std::max((h - lost) + dt * rain, 0.0);
            const double qx = h * from.u(x, y) - lost_x;
            const double qy = (h * from.v(x, y) - lost_y) - dt * (gravity * slope_) * h;
            const double per_depth = 1.0 / std::max(h1, dry_depth);
            const double ux = qx * per_depth;
            const double uy = qy * per_depth;
            const double speed = std::sqrt(ux * ux + uy * uy);
            const double drag = 4.0 * dt * friction;
            const double kept = 2.0 / (1.0 + std::sqrt(1.0 + drag * (speed * per_depth)));
            double u1 = h1 > dry_depth ? ux * kept : 0.0;
            double v1 = h1 > dry_depth ? uy * kept : 0.0;
            if (start != nullptr) {
                const double h0 = start->h(x, y);
                const double h_mean = 0.5 * (h0 + h1);
                const double per_mean = 0.5 / std::max(h_mean, dry_depth);
                const double ux_mean = (h0 * start->u(x, y) + h1 * u1) * per_mean;
                const double uy_mean = (h0 * start->v(x, y) + h1 * v1) * per_mean;
                h1 = h_mean;
                u1 = h_mean > dry_depth ? ux_mean : 0.0;
                v1 = h_mean > dry_depth ? uy_mean : 0.0;
            }
            to.h(x, y) = h1;
            to.u(x, y) = u1;
            to.v(x, y) = v1;
        }
    }
}

}  // namespace fumon::plain
