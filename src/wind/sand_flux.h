#pragma once

#include <vector>

#include "wind/wind_rose.h"

namespace fumon {

/// Vector units of Fryberger & Dean (1979) of each wind: U² (U − U_t)/100 · t, with U and the
/// threshold U_t in knots, 10 m above the ground, and t in percent of the time. Winds below the
/// threshold move nothing and are left out.
std::vector<SandFlux> fryberger_fluxes(const WindRose& rose, double threshold_knots);

/// Sand, air and ground of the saturated flux.
struct SandAndAir {
    double grain_diameter = 250e-6;  ///< m
    double grain_density = 2650.0;   ///< kg/m³
    double air_density = 1.225;      ///< kg/m³
    double viscosity = 1.8e-5;       ///< Pa s
    double gravity = 9.8;            ///< m/s²
    double packing = 0.6226;         ///< share of grains in a bed of sand
    double roughness = 1e-3;         ///< m, of the ground between 0 and 10 m
};

/// The friction velocity, in m/s, below which a saltation that goes on comes to rest: 0.8 of
/// Bagnold's fluid threshold 0.11 √((s − 1) g d).
double impact_threshold(const SandAndAir& of);

/// The saturated flux of sand over a flat bed, kg/(m s), at a friction velocity in m/s: q = (2α/g)
/// τ_t ((u*/u*_t)² − 1) u_s of Sauermann, Kroy & Herrmann (2001) with the scales of Durán & Moore
/// (2013). 0 up to the threshold.
double saturated_flux(const SandAndAir& of, double friction_velocity);

/// The sand that each wind moves in a year, in m² of bed (m³ over a metre's width), by the
/// saturated flux at u* = 0.4 U / ln(10 m / roughness). What moves none is left out.
std::vector<SandFlux> saturated_fluxes(const WindRose& rose, const SandAndAir& of);

}  // namespace fumon
