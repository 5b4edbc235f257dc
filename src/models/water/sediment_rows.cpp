#include "models/water/sediment_rows.h"

#include <cmath>

#include "base/multiversion.h"
#include "models/water/sediment_vectors.h"

namespace fumon::sediment {

namespace {

FUMON_MULTIVERSION
void scale_row(double factor, const double* in, int count, double* out) {
    for (int x = 0; x < count; ++x) out[x] = factor * in[x];
}

inline double larger(double a, double b) {
    return a < b ? b : a;
}

/// What of `amount` goes down a drop of which it may take up to `most`.
inline double within(double amount, double most) {
    return most > 0.0 ? amount * most / (most + amount) : 0.0;
}

}  // namespace

FUMON_MULTIVERSION
void steepness_row(const FluxLaw& law, const Sides& bed, int count, double* steepness) {
    for (int x = 0; x < count; ++x) {
        const double slope_x = (bed.east[x] - bed.west[x]) * law.half_per_x;
        const double slope_y = law.mean_slope + (bed.north[x] - bed.south[x]) * law.half_per_y;
        steepness[x] = slope_x * slope_x + slope_y * slope_y;
    }
}

FUMON_MULTIVERSION
void downhill_row(const FluxLaw& law, const double* here, const Sides& bed, int count,
                  double* steepness, double* drop) {
    const double per_x = 2.0 * law.half_per_x;
    const double per_y = 2.0 * law.half_per_y;
    const double plane = law.mean_slope / per_y;  // the mean plane's fall over a cell
    for (int x = 0; x < count; ++x) {
        const double z = here[x];
        const double drop_x = larger(larger(z - bed.west[x], z - bed.east[x]), 0.0);
        const double drop_y =
            larger(larger((z - bed.south[x]) + plane, (z - bed.north[x]) - plane), 0.0);
        const double slope_x = drop_x * per_x;
        const double slope_y = drop_y * per_y;
        steepness[x] = slope_x * slope_x + slope_y * slope_y;
        drop[x] = larger(drop_x, drop_y);
    }
}

void flux_row(const FluxLaw& law, const double* u, const double* v, int count, double* flux) {
    stress_row(law, u, v, count, flux);
    if (law.transport_exponent != 1.0) raise_row(law.transport_exponent, count, flux);
    if (law.transport_factor != 1.0) scale_row(law.transport_factor, flux, count, flux);
}

FUMON_MULTIVERSION
void direct_row(const double* flux, const double* u, const double* v, int count, double* flux_x,
                double* flux_y) {
    for (int x = 0; x < count; ++x) {
        const double speed = u[x] * u[x] + v[x] * v[x];
        const double per_speed = flux[x] / std::sqrt(speed > tiny ? speed : 1.0);
        flux_x[x] = per_speed * u[x];
        flux_y[x] = per_speed * v[x];
    }
}

FUMON_MULTIVERSION
void sum_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
             double* change) {
    const double per_x = dt * law.half_per_x;
    const double per_y = dt * law.half_per_y;
    for (int x = 0; x < count; ++x) {
        change[x] =
            per_y * (flux_y.north[x] + flux_y.south[x]) - per_x * (flux_x.east[x] + flux_x.west[x]);
    }
}

FUMON_MULTIVERSION
void diverge_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
                 double* change) {
    const double per_x = dt * law.half_per_x;
    const double per_y = dt * law.half_per_y;
    for (int x = 0; x < count; ++x) {
        change[x] =
            per_y * (flux_y.south[x] - flux_y.north[x]) + per_x * (flux_x.west[x] - flux_x.east[x]);
    }
}

void incise_row(const double* flux, double dt, int count, double* change) {
    scale_row(-dt, flux, count, change);
}

FUMON_MULTIVERSION
void incise_downhill_row(const double* flux, const double* drop, double dt, int count,
                         double* change) {
    for (int x = 0; x < count; ++x) change[x] = -within(dt * flux[x], drop[x]);
}

FUMON_MULTIVERSION
void settle_downhill_row(const FluxLaw& law, const double* here, const Sides& bed,
                         const double* flux_x_here, const Sides& flux_x, const double* flux_y_here,
                         const Sides& flux_y, double dt, int count, double* change) {
    constexpr double most = 0.125;  // of a drop, through one of a cell's four faces
    const double per_x = 2.0 * dt * law.half_per_x;
    const double per_y = 2.0 * dt * law.half_per_y;
    const double plane = law.mean_slope / (2.0 * law.half_per_y);
    const auto given = [](double drop, double out, double in) {
        return within(larger(out, 0.0), most * drop) - within(larger(in, 0.0), -most * drop);
    };
    for (int x = 0; x < count; ++x) {
        const double z = here[x];
        const double fx = per_x * flux_x_here[x];
        const double fy = per_y * flux_y_here[x];
        const double east = given(z - bed.east[x], fx, -per_x * flux_x.east[x]);
        const double west = given(z - bed.west[x], -fx, per_x * flux_x.west[x]);
        const double north = given((z - bed.north[x]) - plane, fy, -per_y * flux_y.north[x]);
        const double south = given((z - bed.south[x]) + plane, -fy, per_y * flux_y.south[x]);
        change[x] = -((east + west) + (north + south));
    }
}

FUMON_MULTIVERSION
void hold_between_neighbours(const FluxLaw& law, const double* here, const Sides& bed, int count,
                             double* change) {
    const double plane = law.mean_slope / (2.0 * law.half_per_y);
    for (int x = 0; x < count; ++x) {
        const double z = here[x];
        const double west = z - bed.west[x];
        const double east = z - bed.east[x];
        const double south = (z - bed.south[x]) + plane;
        const double north = (z - bed.north[x]) - plane;
        const double drop = larger(larger(west, east), larger(south, north));
        const double rise = larger(larger(-west, -east), larger(-south, -north));
        const double cut = within(larger(-change[x], 0.0), drop);
        const double fill = within(larger(change[x], 0.0), rise);
        change[x] = fill - cut;
    }
}

FUMON_MULTIVERSION
double row_sum(const double* values, int count) {
    double lane[8] = {};
    int x = 0;
    for (; x + 8 <= count; x += 8) {
        for (int k = 0; k < 8; ++k) lane[k] += values[x + k];
    }
    for (; x < count; ++x) lane[x % 8] += values[x];
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) +
           ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace fumon::sediment
