#include "models/water/sediment_rows.h"

#include <cmath>

#include "base/elementary.h"
#include "base/multiversion.h"

namespace fumon::sediment {

namespace {

/// Squares below this count as it: their powers are 0 in all that matters.
constexpr double tiny = 1e-300;

FUMON_MULTIVERSION
void stress_row(const FluxLaw& law, const Sides& bed, const double* u, const double* v, int count,
                double* excess) {
    const double half_q = 0.5 * law.velocity_exponent;
    const double half_gamma = 0.5 * law.slope_exponent;
    for (int x = 0; x < count; ++x) {
        const double slope_x = (bed.east[x] - bed.west[x]) * law.half_per_x;
        const double slope_y = law.mean_slope + (bed.north[x] - bed.south[x]) * law.half_per_y;
        const double steepness = slope_x * slope_x + slope_y * slope_y;
        const double speed = u[x] * u[x] + v[x] * v[x];
        const double power = elementary::exp(
            half_q * elementary::log_of_normal(speed > tiny ? speed : tiny) +
            half_gamma * elementary::log_of_normal(steepness > tiny ? steepness : tiny));
        const double stress = law.stress_factor * power - law.critical_stress;
        const double above = stress > 0.0 ? stress : 0.0;
        excess[x] = speed > tiny ? above : 0.0;
    }
}

FUMON_MULTIVERSION
void raise_row(double exponent, int count, double* values) {
    for (int x = 0; x < count; ++x) {
        const double power = elementary::exp(
            exponent * elementary::log_of_normal(values[x] > tiny ? values[x] : tiny));
        values[x] = values[x] > tiny ? power : 0.0;
    }
}

FUMON_MULTIVERSION
void scale_row(double factor, const double* in, int count, double* out) {
    for (int x = 0; x < count; ++x) out[x] = factor * in[x];
}

}  // namespace

void flux_row(const FluxLaw& law, const Sides& bed, const double* u, const double* v, int count,
              double* flux) {
    stress_row(law, bed, u, v, count, flux);
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
