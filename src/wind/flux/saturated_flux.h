#pragma once

namespace fumon {

/// Sand, air and ground of the saturated flux.
struct SandAndAir {
    double grain_diameter = 250e-6;  ///< m
    double grain_density = 2650.0;   ///< kg/m³
    double air_density = 1.225;      ///< kg/m³
    double viscosity = 1.8e-5;       ///< Pa s
    double gravity = 9.8;            ///< m/s²
    double packing = 0.6226;         ///< share of grains in a bed of sand
    double roughness = 1e-3;         ///< m, of the ground, by which speeds become u*
};

/// The friction velocity, in m/s, below which a saltation that goes on comes to rest: 0.8 of
/// Bagnold's fluid threshold 0.11 √((s − 1) g d).
double impact_threshold(const SandAndAir& of);

/// The saturated flux of sand over a flat bed, kg/(m s), at a friction velocity in m/s: q = (2α/g)
/// τ_t ((u*/u*_t)² − 1) u_s of Sauermann, Kroy & Herrmann (2001) with the scales of Durán & Moore
/// (2013). 0 up to the threshold.
double saturated_flux(const SandAndAir& of, double friction_velocity);

/// u* in m/s of a wind of so many m/s at a height in metres above the ground, above its roughness:
/// u* = 0.4 U / ln(height / roughness).
double friction_velocity(const SandAndAir& of, double speed, double height);

/// The saturated flux in m² of bed (m³ over a metre's width) a year of a wind that blows all the
/// time.
double yearly_flux(const SandAndAir& of, double friction_velocity);

}  // namespace fumon
