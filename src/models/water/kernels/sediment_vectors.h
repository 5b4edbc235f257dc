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
    double mean_slope;    ///< toward −y
    double mean_slope_x;  ///< toward +x
    double half_per_x;    ///< 1 / 2dx
    double half_per_y;
};

/// S² of a row by central differences.
void steepness_row(const FluxLaw& law, const Sides& bed, int count, double* steepness);

/// S² of a row toward the lower neighbour on either axis, 0 in a hollow (Rouy & Tourin 1992), and
/// the height above the lowest of them, m.
void downhill_row(const FluxLaw& law, const double* here, const Sides& bed, int count,
                  double* steepness, double* drop);

/// |q_s|, m²/s, of a row, in place of its S²; 0 where the water stands. U^q S^γ = exp(q/2 ln U² +
/// γ/2 ln S²), within 1e-13 of its value.
void flux_row(const FluxLaw& law, const double* u, const double* v, int count, double* flux);

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

/// The same, but implicit in the cell's drop d, −a d / (d + a) for a = dt |q_s| / (1 m): less than
/// the drop for any sub-step, a where that is small.
void incise_downhill_row(const double* flux, const double* drop, double dt, int count,
                         double* change);

/// −∇·q_s from the cells upstream, in `dt`. Sediment passes a face downhill only, an eighth of the
/// drop at most, as in incise_downhill_row: no cell becomes lower or higher than all its
/// neighbours.
void settle_downhill_row(const FluxLaw& law, const double* here, const Sides& bed,
                         const double* flux_x_here, const Sides& flux_x, const double* flux_y_here,
                         const Sides& flux_y, double dt, int count, double* change);

/// Holds changes within the bed around them, as incise_downhill_row does: less than the drop to the
/// lowest neighbour, or than the rise to the highest.
void hold_between_neighbours(const FluxLaw& law, const double* here, const Sides& bed, int count,
                             double* change);

/// The sum of a row in a fixed order.
double row_sum(const double* values, int count);

}  // namespace fumon::sediment
