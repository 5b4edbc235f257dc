#include "models/water/cip_rows.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/multiversion.h"

namespace fumon::cip {

namespace {

/// Water shallower than this, in metres, stands still: it is less than a molecule.
constexpr double dry_depth = 1e-10;

/// All bits set where true: picks without a branch, so that loops vectorise.
std::uint64_t mask_of(bool yes) {
    return yes ? ~std::uint64_t{0} : 0;
}

double pick(std::uint64_t mask, double where_set, double elsewhere) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(where_set) & mask) |
                                 (std::bit_cast<std::uint64_t>(elsewhere) & ~mask));
}

inline double smaller(double a, double b) {
    return b < a ? b : a;
}

inline double larger(double a, double b) {
    return a < b ? b : a;
}

}  // namespace

FUMON_MULTIVERSION
void advect_row(const CarriedStencil& before, const double* u, const double* v, const SubStep& step,
                int count, const CarriedRow& after) {
    const double* fs = before.value.south;
    const double* fh = before.value.here;
    const double* fn = before.value.north;
    const double* xs = before.gradient_x.south;
    const double* xh = before.gradient_x.here;
    const double* xn = before.gradient_x.north;
    const double* ys = before.gradient_y.south;
    const double* yh = before.gradient_y.here;
    const double* yn = before.gradient_y.north;
    double* value = after.value;
    double* gradient_x = after.gradient_x;
    double* gradient_y = after.gradient_y;
    const double per_x = step.dt / step.dx;
    const double per_y = step.dt / step.dy;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const std::uint64_t west = mask_of(u[x] > 0.0);  // where the water comes from
        const std::uint64_t south = mask_of(v[x] > 0.0);
        const double sign_x = pick(west, -1.0, 1.0);
        const double sign_y = pick(south, -1.0, 1.0);
        const double f0 = fh[x];
        const double f1 = pick(west, fh[x - 1], fh[x + 1]);
        const double f2 = pick(south, fs[x], fn[x]);
        const double f3 =
            pick(west, pick(south, fs[x - 1], fn[x - 1]), pick(south, fs[x + 1], fn[x + 1]));
        const double p0 = sign_x * xh[x];
        const double p1 = sign_x * pick(west, xh[x - 1], xh[x + 1]);
        const double p2 = sign_x * pick(south, xs[x], xn[x]);
        const double q0 = sign_y * yh[x];
        const double q1 = sign_y * pick(west, yh[x - 1], yh[x + 1]);
        const double q2 = sign_y * pick(south, ys[x], yn[x]);
        const double rise_x = f1 - f0;
        const double rise_y = f2 - f0;
        const double c30 = p0 + p1 - 2.0 * rise_x;
        const double c20 = 3.0 * rise_x - 2.0 * p0 - p1;
        const double c03 = q0 + q2 - 2.0 * rise_y;
        const double c02 = 3.0 * rise_y - 2.0 * q0 - q2;
        const double twist = (f3 - f1) - rise_y;
        const double c12 = twist - (q1 - q0);
        const double c21 = twist - (p2 - p0);
        const double c11 = (q1 - q0) - c21;
        const double a = -sign_x * u[x] * per_x;  // how far upwind, in cells
        const double b = -sign_y * v[x] * per_y;
        value[x] = f0 + a * (p0 + a * (c20 + a * c30) + b * (c11 + a * c21 + b * c12)) +
                   b * (q0 + b * (c02 + b * c03));
        gradient_x[x] =
            sign_x * (p0 + a * (2.0 * c20 + 3.0 * a * c30) + b * (c11 + 2.0 * a * c21 + b * c12));
        gradient_y[x] =
            sign_y * (q0 + b * (2.0 * c02 + 3.0 * b * c03) + a * (c11 + a * c21 + 2.0 * b * c12));
    }
}

FUMON_MULTIVERSION
void accelerate_row(const Stencil& depth, const Stencil& bed, const SubStep& step, int count,
                    const double* advected_u, const double* advected_v, double* u, double* v,
                    double* gained_u, double* gained_v) {
    const double* h = depth.here;
    const double* hs = depth.south;
    const double* hn = depth.north;
    const double* z = bed.here;
    const double* zs = bed.south;
    const double* zn = bed.north;
    double* u_after = u;
    double* v_after = v;
    double* u_gain = gained_u;
    double* v_gain = gained_v;
    const double* in_u = advected_u;
    const double* in_v = advected_v;
    const double push_x = -0.5 * step.dt * step.gravity / step.dx;
    const double push_y = -0.5 * step.dt * step.gravity / step.dy;
    const double pull = step.dt * step.pull;
    const double drag = step.dt * step.friction;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double free_u = in_u[x] + push_x * ((h[x + 1] - h[x - 1]) + (z[x + 1] - z[x - 1]));
        const double free_v = in_v[x] + pull + push_y * ((hn[x] - hs[x]) + (zn[x] - zs[x]));
        const double speed = std::sqrt(in_u[x] * in_u[x] + in_v[x] * in_v[x]);
        const std::uint64_t wet = mask_of(h[x] > dry_depth);
        const double kept = pick(wet, h[x], 0.0) / (pick(wet, h[x], 1.0) + drag * speed);
        u_after[x] = kept * free_u;
        v_after[x] = kept * free_v;
        u_gain[x] = u_after[x] - in_u[x];
        v_gain[x] = v_after[x] - in_v[x];
    }
}

namespace {

/// The rise of the surface from one neighbour to the other, from the rises toward either.
inline double limited_rise(double back, double depth_back, double forward, double depth_forward) {
    const double to_back = smaller(back, larger(depth_back, -forward));
    const double to_forward = smaller(forward, larger(depth_forward, -back));
    return to_forward - to_back;
}

}  // namespace

FUMON_MULTIVERSION
void accelerate_row_steep(const Stencil& depth, const Stencil& bed, const SubStep& step, int count,
                          const double* advected_u, const double* advected_v, double* u, double* v,
                          double* gained_u, double* gained_v) {
    const double* h = depth.here;
    const double* hs = depth.south;
    const double* hn = depth.north;
    const double* z = bed.here;
    const double* zs = bed.south;
    const double* zn = bed.north;
    double* u_after = u;
    double* v_after = v;
    double* u_gain = gained_u;
    double* v_gain = gained_v;
    const double* in_u = advected_u;
    const double* in_v = advected_v;
    const double push_x = -0.5 * step.dt * step.gravity / step.dx;
    const double push_y = -0.5 * step.dt * step.gravity / step.dy;
    const double plane = -step.pull * step.dy / step.gravity;  // its rise from a row to the next
    const double drag = 4.0 * step.dt * step.friction;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double west = (h[x - 1] - h[x]) + (z[x - 1] - z[x]);
        const double east = (h[x + 1] - h[x]) + (z[x + 1] - z[x]);
        const double south = ((hs[x] - h[x]) + (zs[x] - z[x])) - plane;
        const double north = ((hn[x] - h[x]) + (zn[x] - z[x])) + plane;
        const double free_u = in_u[x] + push_x * limited_rise(west, h[x - 1], east, h[x + 1]);
        const double free_v = in_v[x] + push_y * limited_rise(south, hs[x], north, hn[x]);
        const double speed = std::sqrt(free_u * free_u + free_v * free_v);
        const std::uint64_t wet = mask_of(h[x] > dry_depth);
        const double per_depth = 1.0 / pick(wet, h[x], 1.0);
        const double kept =
            pick(wet, 2.0 / (1.0 + std::sqrt(1.0 + drag * (speed * per_depth))), 0.0);
        u_after[x] = kept * free_u;
        v_after[x] = kept * free_v;
        u_gain[x] = u_after[x] - in_u[x];
        v_gain[x] = v_after[x] - in_v[x];
    }
}

FUMON_MULTIVERSION
void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const double* u_before,
                                 const double* v_before, const SubStep& step, int count,
                                 const double* advected_u, const double* advected_v, double* u,
                                 double* v, double* gained_u, double* gained_v) {
    const double* h = depth.here;
    const double* hs = depth.south;
    const double* hn = depth.north;
    const double* z = bed.here;
    const double* zs = bed.south;
    const double* zn = bed.north;
    const double* old_u = u_before;
    const double* old_v = v_before;
    const double* in_u = advected_u;
    const double* in_v = advected_v;
    double* u_after = u;
    double* v_after = v;
    double* u_gain = gained_u;
    double* v_gain = gained_v;
    const double push_x = -0.5 * step.dt * step.gravity / step.dx;
    const double push_y = -0.5 * step.dt * step.gravity / step.dy;
    const double pull = step.dt * step.pull;
    const double drag = step.dt * step.friction;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double speed = std::sqrt(old_u[x] * old_u[x] + old_v[x] * old_v[x]);
        const double lost = drag * speed / h[x];
        u_gain[x] = push_x * ((h[x + 1] - h[x - 1]) + (z[x + 1] - z[x - 1])) - lost * old_u[x];
        v_gain[x] = (pull + push_y * ((hn[x] - hs[x]) + (zn[x] - zs[x]))) - lost * old_v[x];
        u_after[x] = in_u[x] + u_gain[x];
        v_after[x] = in_v[x] + v_gain[x];
    }
}

FUMON_MULTIVERSION
void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, double* gradient_x, double* gradient_y) {
    const double* gain = gained.here;
    const double* gain_s = gained.south;
    const double* gain_n = gained.north;
    const double* u_here = u.here;
    const double* u_s = u.south;
    const double* u_n = u.north;
    const double* v_here = v.here;
    const double* v_s = v.south;
    const double* v_n = v.north;
    double* fx = gradient_x;
    double* fy = gradient_y;
    const double half_x = 0.5 * step.dt / step.dx;
    const double half_y = 0.5 * step.dt / step.dy;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double along = half_x * fx[x];
        const double across = half_y * fy[x];
        const double u_x = u_here[x + 1] - u_here[x - 1];
        const double u_y = u_n[x] - u_s[x];
        const double v_x = v_here[x + 1] - v_here[x - 1];
        const double v_y = v_n[x] - v_s[x];
        fx[x] += 0.5 * (gain[x + 1] - gain[x - 1]) - (u_x * along + v_x * across);
        fy[x] += 0.5 * (gain_n[x] - gain_s[x]) - (u_y * along + v_y * across);
    }
}

FUMON_MULTIVERSION
void hold_advected_row(const Stencil& before, const double* u, const double* v, int count,
                       double* value) {
    const double* fs = before.south;
    const double* fh = before.here;
    const double* fn = before.north;
    double* held = value;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const std::uint64_t west = mask_of(u[x] > 0.0);
        const std::uint64_t south = mask_of(v[x] > 0.0);
        const double f0 = fh[x];
        const double f1 = pick(west, fh[x - 1], fh[x + 1]);
        const double f2 = pick(south, fs[x], fn[x]);
        const double f3 =
            pick(west, pick(south, fs[x - 1], fn[x - 1]), pick(south, fs[x + 1], fn[x + 1]));
        const double low = smaller(smaller(f0, f1), smaller(f2, f3));
        const double high = larger(larger(f0, f1), larger(f2, f3));
        held[x] = smaller(larger(held[x], low), high);
    }
}

FUMON_MULTIVERSION
void hold_gradient_row(const Stencil& value, int count, double* gradient_x, double* gradient_y) {
    const double* fs = value.south;
    const double* fh = value.here;
    const double* fn = value.north;
    double* gx = gradient_x;
    double* gy = gradient_y;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double f = fh[x];
        const double most_x = 2.0 * larger(std::fabs(fh[x + 1] - f), std::fabs(f - fh[x - 1]));
        const double most_y = 2.0 * larger(std::fabs(fn[x] - f), std::fabs(f - fs[x]));
        gx[x] = smaller(larger(gx[x], -most_x), most_x);
        gy[x] = smaller(larger(gy[x], -most_y), most_y);
    }
}

FUMON_MULTIVERSION
void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained) {
    const double* u_here = u.here;
    const double* v_s = v.south;
    const double* v_n = v.north;
    const double half_x = 0.5 * step.dt / step.dx;
    const double half_y = 0.5 * step.dt / step.dy;
    const double fallen = step.dt * rain;
    FUMON_INDEPENDENT
    for (int x = 0; x < count; ++x) {
        const double spread = half_x * (u_here[x + 1] - u_here[x - 1]) + half_y * (v_n[x] - v_s[x]);
        gained[x] = fallen - depth[x] * spread;
        after[x] = advected[x] + gained[x];
    }
}

}  // namespace fumon::cip
