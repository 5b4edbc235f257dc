#pragma once

namespace fumon::sediment {

/// A row of cells' neighbours, one array to each side.
struct Sides {
    const double* west;
    const double* east;
    const double* south;
    const double* north;
};

/// K_f, K_t, τ_c, p, q, γ of q_s = K_f (K_t U^q S^γ − τ_c)^p, and the mean plane it holds on.
struct FluxLaw {
    double transport_factor;
    double stress_factor;
    double critical_stress;
    double transport_exponent;
    double velocity_exponent;
    double slope_exponent;
    double mean_slope;
    double half_per_x;  ///< 1 / 2dx
    double half_per_y;
};

/// |q_s|, m²/s, of a row; 0 where the water stands. U^q S^γ = exp(q/2 ln U² + γ/2 ln S²), within
/// 1e-13 of its value.
void flux_row(const FluxLaw& law, const Sides& bed, const double* u, const double* v, int count,
              double* flux);

/// The flux's components, along the flow.
void direct_row(const double* flux, const double* u, const double* v, int count, double* flux_x,
                double* flux_y);

/// Eq. (12) as printed, its y axis pointing down the plane: what the bed changes in `dt`.
void sum_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
             double* change);

/// −∇·q_s by central differences: what the bed changes in `dt`.
void diverge_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
                 double* change);

/// −dt |q_s| / (1 m).
void incise_row(const double* flux, double dt, int count, double* change);

/// The sum of a row in a fixed order.
double row_sum(const double* values, int count);

}  // namespace fumon::sediment
