#include "models/cip_rows.h"

#include <cmath>

#include "models/dry_depth.h"
#include "support/multiversion.h"

namespace fumon::cip {

FUMON_MULTIVERSION
void advect_row(const CarriedStencil& before, const double* u, const double* v, const SubStep& step,
                int count, const CarriedRow& after) {
    const double* __restrict fs = before.value.south;
    const double* __restrict fh = before.value.here;
    const double* __restrict fn = before.value.north;
    const double* __restrict xs = before.gradient_x.south;
    const double* __restrict xh = before.gradient_x.here;
    const double* __restrict xn = before.gradient_x.north;
    const double* __restrict ys = before.gradient_y.south;
    const double* __restrict yh = before.gradient_y.here;
    const double* __restrict yn = before.gradient_y.north;
    double* __restrict value = after.value;
    double* __restrict gradient_x = after.gradient_x;
    double* __restrict gradient_y = after.gradient_y;
    const double per_x = step.dt / step.dx;
    const double per_y = step.dt / step.dy;
    for (int x = 0; x < count; ++x) {
        const bool west = u[x] > 0.0;  // where the water comes from
        const bool south = v[x] > 0.0;
        const double sign_x = west ? -1.0 : 1.0;
        const double sign_y = south ? -1.0 : 1.0;
        const double f_w = fh[x - 1];
        const double f_e = fh[x + 1];
        const double f_s = fs[x];
        const double f_n = fn[x];
        const double f_sw = fs[x - 1];
        const double f_se = fs[x + 1];
        const double f_nw = fn[x - 1];
        const double f_ne = fn[x + 1];
        const double x_w = xh[x - 1];
        const double x_e = xh[x + 1];
        const double x_s = xs[x];
        const double x_n = xn[x];
        const double y_w = yh[x - 1];
        const double y_e = yh[x + 1];
        const double y_s = ys[x];
        const double y_n = yn[x];
        const double f0 = fh[x];
        const double f1 = west ? f_w : f_e;
        const double f2 = south ? f_s : f_n;
        const double corner_w = south ? f_sw : f_nw;
        const double corner_e = south ? f_se : f_ne;
        const double f3 = west ? corner_w : corner_e;
        const double p0 = sign_x * xh[x];
        const double p1 = sign_x * (west ? x_w : x_e);
        const double p2 = sign_x * (south ? x_s : x_n);
        const double q0 = sign_y * yh[x];
        const double q1 = sign_y * (west ? y_w : y_e);
        const double q2 = sign_y * (south ? y_s : y_n);
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
    const double* __restrict h = depth.here;
    const double* __restrict hs = depth.south;
    const double* __restrict hn = depth.north;
    const double* __restrict z = bed.here;
    const double* __restrict zs = bed.south;
    const double* __restrict zn = bed.north;
    double* __restrict u_after = u;
    double* __restrict v_after = v;
    double* __restrict u_gain = gained_u;
    double* __restrict v_gain = gained_v;
    const double push_x = -0.5 * step.dt * step.gravity / step.dx;
    const double push_y = -0.5 * step.dt * step.gravity / step.dy;
    const double pull = step.dt * step.pull;
    const double drag = step.dt * step.friction;
    for (int x = 0; x < count; ++x) {
        const double free_u =
            advected_u[x] + push_x * ((h[x + 1] - h[x - 1]) + (z[x + 1] - z[x - 1]));
        const double free_v = advected_v[x] + pull + push_y * ((hn[x] - hs[x]) + (zn[x] - zs[x]));
        const double speed =
            std::sqrt(advected_u[x] * advected_u[x] + advected_v[x] * advected_v[x]);
        const double wet = h[x] > dry_depth ? h[x] : 0.0;
        const double kept = wet / ((h[x] > dry_depth ? h[x] : 1.0) + drag * speed);
        u_after[x] = kept * free_u;
        v_after[x] = kept * free_v;
        u_gain[x] = u_after[x] - advected_u[x];
        v_gain[x] = v_after[x] - advected_v[x];
    }
}

FUMON_MULTIVERSION
void accelerate_row_as_published(const Stencil& depth, const Stencil& bed, const double* u_before,
                                 const double* v_before, const SubStep& step, int count,
                                 const double* advected_u, const double* advected_v, double* u,
                                 double* v, double* gained_u, double* gained_v) {
    const double* h = depth.here;
    const double* z = bed.here;
    const double push_x = -0.5 * step.gravity / step.dx;
    const double push_y = -0.5 * step.gravity / step.dy;
    for (int x = 0; x < count; ++x) {
        const double drag =
            step.friction * std::sqrt(u_before[x] * u_before[x] + v_before[x] * v_before[x]) / h[x];
        const double force_x = push_x * ((h[x + 1] - h[x - 1]) + (z[x + 1] - z[x - 1]));
        const double force_y = step.pull + push_y * ((depth.north[x] - depth.south[x]) +
                                                     (bed.north[x] - bed.south[x]));
        gained_u[x] = step.dt * (force_x - drag * u_before[x]);
        gained_v[x] = step.dt * (force_y - drag * v_before[x]);
        u[x] = advected_u[x] + gained_u[x];
        v[x] = advected_v[x] + gained_v[x];
    }
}

FUMON_MULTIVERSION
void turn_gradient_row(const Stencil& gained, const Stencil& u, const Stencil& v,
                       const SubStep& step, int count, double* gradient_x, double* gradient_y) {
    const double* __restrict gain = gained.here;
    const double* __restrict gain_s = gained.south;
    const double* __restrict gain_n = gained.north;
    double* __restrict fx = gradient_x;
    double* __restrict fy = gradient_y;
    const double half_x = 0.5 * step.dt / step.dx;
    const double half_y = 0.5 * step.dt / step.dy;
    for (int x = 0; x < count; ++x) {
        const double along = half_x * fx[x];
        const double across = half_y * fy[x];
        const double u_x = u.here[x + 1] - u.here[x - 1];
        const double u_y = u.north[x] - u.south[x];
        const double v_x = v.here[x + 1] - v.here[x - 1];
        const double v_y = v.north[x] - v.south[x];
        fx[x] += 0.5 * (gain[x + 1] - gain[x - 1]) - (u_x * along + v_x * across);
        fy[x] += 0.5 * (gain_n[x] - gain_s[x]) - (u_y * along + v_y * across);
    }
}

FUMON_MULTIVERSION
void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained) {
    const double half_x = 0.5 * step.dt / step.dx;
    const double half_y = 0.5 * step.dt / step.dy;
    for (int x = 0; x < count; ++x) {
        const double spread =
            half_x * (u.here[x + 1] - u.here[x - 1]) + half_y * (v.north[x] - v.south[x]);
        gained[x] = step.dt * rain - depth[x] * spread;
        after[x] = advected[x] + gained[x];
    }
}

}  // namespace fumon::cip
