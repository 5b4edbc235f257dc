#include "models/water/finite_volume_rows.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/multiversion.h"

namespace fumon::finite_volume {

namespace {

constexpr double dry_depth = 1e-9;  // m: thinner water rests, but is kept
constexpr double no_speed = 1e-300;

inline double smaller(double a, double b) {
    return b < a ? b : a;
}

inline double larger(double a, double b) {
    return a < b ? b : a;
}

/// `bound`: half of the steepest slope over the smaller one-sided difference, from ½ (minmod, with
/// which the values of two cells at their face keep their order) to 1 (monotonised central).
inline double half_slope(double back, double forward, double bound) {
    const double middle = 0.25 * (back + forward);
    const double rising = smaller(bound * smaller(back, forward), middle);
    const double falling = larger(bound * larger(back, forward), middle);
    return larger(rising, 0.0) + smaller(falling, 0.0);
}

}  // namespace

FUMON_MULTIVERSION void add_rows(const double* a, const double* b, double* out, int count) {
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) out[k] = a[k] + b[k];
}

FUMON_MULTIVERSION void scale_row(const double* values, double factor, double* out, int count) {
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) out[k] = factor * values[k];
}

FUMON_MULTIVERSION void limited_half_slopes(const CellRow& back, const CellRow& here,
                                            const CellRow& forward, const HalfSlopes& out,
                                            int count) {
    const CellRow b = back;
    const CellRow c = here;
    const CellRow f = forward;
    double* __restrict depth = out.depth;
    double* __restrict surface = out.surface;
    double* __restrict normal = out.normal;
    double* __restrict transverse = out.transverse;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double with_back = b.inside[k] * c.inside[k];
        const double with_forward = f.inside[k] * c.inside[k];
        const double depth_back = (c.depth[k] - b.depth[k]) * with_back;
        const double depth_forward = (f.depth[k] - c.depth[k]) * with_forward;
        const double surface_back = (c.surface[k] - b.surface[k]) * with_back;
        const double surface_forward = (f.surface[k] - c.surface[k]) * with_forward;
        const double shallowest = smaller(smaller(b.depth[k], f.depth[k]), c.depth[k]);
        const double bed_step = larger(std::fabs(surface_back - depth_back),
                                       std::fabs(surface_forward - depth_forward));
        const double bound = shallowest > bed_step ? 1.0 : 0.5;
        depth[k] = half_slope(depth_back, depth_forward, bound);
        surface[k] = half_slope(surface_back, surface_forward, bound);
        normal[k] = half_slope((c.normal[k] - b.normal[k]) * with_back,
                               (f.normal[k] - c.normal[k]) * with_forward, 1.0);
        transverse[k] = half_slope((c.transverse[k] - b.transverse[k]) * with_back,
                                   (f.transverse[k] - c.transverse[k]) * with_forward, 1.0);
    }
}

FUMON_MULTIVERSION void face_fluxes(const CellRow& left, const HalfSlopes& left_slopes,
                                    const CellRow& right, const HalfSlopes& right_slopes,
                                    double gravity, const Fluxes& out, int count) {
    const CellRow l = left;
    const CellRow r = right;
    const HalfSlopes ls = left_slopes;
    const HalfSlopes rs = right_slopes;
    double* __restrict mass_out = out.mass;
    double* __restrict left_out = out.left;
    double* __restrict right_out = out.right;
    double* __restrict transverse_out = out.transverse;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double depth_l = l.depth[k] + ls.depth[k];
        const double depth_r = r.depth[k] - rs.depth[k];
        const double level_l = l.surface[k] + ls.surface[k];
        const double level_r = r.surface[k] - rs.surface[k];
        const double ground_l = level_l - depth_l;
        const double ground_r = level_r - depth_r;
        const double bed_l = l.inside[k] != 0.0 ? ground_l : ground_r;
        const double bed_r = r.inside[k] != 0.0 ? ground_r : ground_l;
        const double surface_l = l.inside[k] != 0.0 ? level_l : ground_r;
        const double surface_r = r.inside[k] != 0.0 ? level_r : ground_l;

        const double step = smaller(larger(bed_l, bed_r), smaller(surface_l, surface_r));
        const double above_l = surface_l - step;
        const double above_r = surface_r - step;
        const double hl = smaller(above_l, depth_l);
        const double hr = smaller(above_r, depth_r);

        const double cl = std::sqrt(gravity * hl);
        const double cr = std::sqrt(gravity * hr);
        const double un_l = l.normal[k] + ls.normal[k];
        const double un_r = r.normal[k] - rs.normal[k];
        const double front_l = un_r - 2.0 * cr;
        const double front_r = un_l + 2.0 * cl;
        const double ul = hl > 0.0 ? un_l : front_l;
        const double ur = hr > 0.0 ? un_r : front_r;
        const double u_star = 0.5 * (ul + ur) + (cl - cr);
        const double c_star = 0.5 * (cl + cr) + 0.25 * (ul - ur);
        const double slowest = smaller(smaller(ul - cl, u_star - c_star), 0.0);
        const double quickest = larger(larger(ur + cr, u_star + c_star), 0.0);
        const double share = 1.0 / larger(quickest - slowest, no_speed);

        const double ql = hl * ul;
        const double qr = hr * ur;
        const double both = slowest * quickest;
        const double mass = ((quickest * ql - slowest * qr) + both * (hr - hl)) * share;
        const double carried = (quickest * (ql * ul) - slowest * (qr * ur)) + both * (qr - ql);
        const double half_gravity = 0.5 * gravity;
        const double pressure_rise = half_gravity * ((hr - hl) * (hr + hl));
        const double fall_l = half_gravity * ((depth_l + hl) * (hl - above_l));
        const double fall_r = half_gravity * ((depth_r + hr) * (hr - above_r));
        const double against_l = larger(un_l, 0.0);
        const double against_r = smaller(un_r, 0.0);
        const double stopped_l = (depth_l - hl) * (against_l * against_l);
        const double stopped_r = (depth_r - hr) * (against_r * against_r);
        mass_out[k] = mass;
        left_out[k] = (carried - slowest * pressure_rise) * share + (fall_l + stopped_l);
        right_out[k] = (carried - quickest * pressure_rise) * share + (fall_r + stopped_r);
        transverse_out[k] = larger(mass, 0.0) * (l.transverse[k] + ls.transverse[k]) +
                            smaller(mass, 0.0) * (r.transverse[k] - rs.transverse[k]);
    }
}

FUMON_MULTIVERSION bool payable_shares(const double* depth, const double* mass_west,
                                       const double* mass_east, const double* mass_south,
                                       const double* mass_north, double dt_dx, double dt_dy,
                                       double* shares, int count) {
    const auto outward = [=](int k) {
        return dt_dx * (larger(mass_east[k], 0.0) - smaller(mass_west[k], 0.0)) +
               dt_dy * (larger(mass_north[k], 0.0) - smaller(mass_south[k], 0.0));
    };
    std::int64_t short_of_water = 0;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) short_of_water |= outward(k) > depth[k] ? 1 : 0;
    if (short_of_water == 0) return false;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double out = outward(k);
        shares[k] = out > depth[k] ? depth[k] / out : 1.0;
    }
    return true;
}

FUMON_MULTIVERSION void cut_to_shares(const Fluxes& fluxes, const double* left_shares,
                                      const double* right_shares, int count) {
    double* __restrict mass = fluxes.mass;
    double* __restrict left = fluxes.left;
    double* __restrict right = fluxes.right;
    double* __restrict transverse = fluxes.transverse;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double share = mass[k] > 0.0 ? left_shares[k] : right_shares[k];
        mass[k] *= share;
        left[k] *= share;
        right[k] *= share;
        transverse[k] *= share;
    }
}

namespace {

template <bool heun>
inline __attribute__((always_inline)) void update_row(const UpdateInput& in,
                                                      const UpdateFactors& factors,
                                                      double* depth_out, double* x_out,
                                                      double* y_out, int count) {
    const UpdateInput i = in;
    const UpdateFactors f = factors;
    double* __restrict depth = depth_out;
    double* __restrict velocity_x = x_out;
    double* __restrict velocity_y = y_out;
    const double twice_gravity = 2.0 * f.gravity;
    const double rain = f.dt * f.rain;
    const double pull = f.dt * f.pull;
    const double drag = 4.0 * f.dt * f.friction;
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double h = i.cells.depth[k];
        const double weight = twice_gravity * h;
        const double lost = f.dt_dx * (i.east.mass[k] - i.west.mass[k]) +
                            f.dt_dy * (i.north.mass[k] - i.south.mass[k]);
        const double lost_x =
            f.dt_dx * ((i.east.left[k] - i.west.right[k]) + weight * i.surface_x[k]) +
            f.dt_dy * (i.north.transverse[k] - i.south.transverse[k]);
        const double lost_y =
            f.dt_dy * ((i.north.left[k] - i.south.right[k]) + weight * i.surface_y[k]) +
            f.dt_dx * (i.east.transverse[k] - i.west.transverse[k]);
        double h1 = larger((h - lost) + rain, 0.0) * i.cells.inside[k];
        const double qx = h * i.cells.normal[k] - lost_x;
        const double qy = (h * i.cells.transverse[k] - lost_y) - pull * h;
        const double per_depth = 1.0 / larger(h1, dry_depth);
        const double ux = qx * per_depth;
        const double uy = qy * per_depth;
        const double speed = std::sqrt(ux * ux + uy * uy);
        const double kept = 2.0 / (1.0 + std::sqrt(1.0 + drag * (speed * per_depth)));
        double u1 = h1 > dry_depth ? ux * kept : 0.0;
        double v1 = h1 > dry_depth ? uy * kept : 0.0;
        if constexpr (heun) {
            const double h0 = i.depth_before[k];
            const double h_mean = 0.5 * (h0 + h1);
            const double per_mean = 0.5 / larger(h_mean, dry_depth);
            const double ux_mean = (h0 * i.x_before[k] + h1 * u1) * per_mean;
            const double uy_mean = (h0 * i.y_before[k] + h1 * v1) * per_mean;
            h1 = h_mean;
            u1 = h_mean > dry_depth ? ux_mean : 0.0;
            v1 = h_mean > dry_depth ? uy_mean : 0.0;
        }
        depth[k] = h1;
        velocity_x[k] = u1;
        velocity_y[k] = v1;
    }
}

}  // namespace

FUMON_MULTIVERSION void update(const UpdateInput& in, const UpdateFactors& factors, double* depth,
                               double* velocity_x, double* velocity_y, int count) {
    if (in.depth_before == nullptr) {
        update_row<false>(in, factors, depth, velocity_x, velocity_y, count);
    } else {
        update_row<true>(in, factors, depth, velocity_x, velocity_y, count);
    }
}

FUMON_MULTIVERSION double fastest(const double* depth, const double* velocity_x,
                                  const double* velocity_y, double gravity, double dx, double dy,
                                  int count) {
    constexpr std::int64_t without_sign = 0x7fffffffffffffff;
    std::int64_t most = 0;  // positive doubles order as their bits do, and NaN is above them all
    FUMON_INDEPENDENT
    for (int k = 0; k < count; ++k) {
        const double c = std::sqrt(gravity * depth[k]);
        const double rate =
            (std::fabs(velocity_x[k]) + c) / dx + (std::fabs(velocity_y[k]) + c) / dy;
        const std::int64_t bits = std::bit_cast<std::int64_t>(rate) & without_sign;
        most = bits > most ? bits : most;
    }
    return std::bit_cast<double>(most);
}

}  // namespace fumon::finite_volume
