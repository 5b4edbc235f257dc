#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// What the update of a row of cells reads; each flux at the cell's face on that side.
struct UpdateInput {
    CellRow cells{};                    ///< normal: u, transverse: v
    const double* surface_x = nullptr;  ///< half slopes of the surface
    const double* surface_y = nullptr;
    Fluxes west{};
    Fluxes east{};
    Fluxes south{};
    Fluxes north{};
    const double* rain = nullptr;  ///< m/s
    /// C_f of τ = ρ · C_f · |u| u, or g n² of τ = ρ · g n² · h^(−1/3) · |u| u
    const double* friction = nullptr;
    const double* depth_before = nullptr;  ///< of the step's start, or null
    const double* x_before = nullptr;
    const double* y_before = nullptr;
    const double* most_speed = nullptr;  ///< m/s, of water no deeper than `thin`; null: no bound
    const double* thin = nullptr;        ///< m
};

struct UpdateFactors {
    double dt = 0.0;     ///< s
    double dt_dx = 0.0;  ///< s/m
    double dt_dy = 0.0;
    double gravity = 0.0;  ///< m/s²
    double pull = 0.0;     ///< g·slope, m/s², toward −y
    double pull_x = 0.0;   ///< … toward −x
    bool manning = false;  ///< friction is Manning's
    double kept = 0.5;     ///< of the step's start, where that is given
};

/// The most cells that `update` takes.
inline constexpr int widest_update = 512;

/// Depth and velocities after an Euler step, friction implicit; where the step's start is
/// given, mixed with it: `kept` of it and 1 − `kept` of the Euler step's (Heun; Shu & Osher 1988).
void update(const UpdateInput& in, const UpdateFactors& factors, double* depth, double* velocity_x,
            double* velocity_y, int count);

}  // namespace fumon::finite_volume
