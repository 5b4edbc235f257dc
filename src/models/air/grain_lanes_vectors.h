#pragma once

#include <array>
#include <cstddef>

namespace fumon {

/// Grains in flight side by side, a lane of a vector each. SI units.
struct GrainLanes {
    static constexpr int most = 32;
    using Values = std::array<double, static_cast<std::size_t>(most)>;

    alignas(64) Values x{};  ///< within the section's width
    alignas(64) Values z{};
    alignas(64) Values speed_x{};
    alignas(64) Values speed_z{};
    alignas(64) Values turns{};    ///< how often the grain has gone round the section
    alignas(64) Values steps{};    ///< done
    alignas(64) Values fastest{};  ///< largest (velocity relative to the air)²
    alignas(64) Values flying{};   ///< 1 until it is at the bed or through the lid, then 0
};

/// What grains fly in: node (i, k) at x = i·dx, z = k·dz holds entry k·(nx + 2) + i of the
/// velocities, with columns nx and nx + 1 those of 0 and 1, and row nz that of nz − 1. SI units.
struct LaneAir {
    const double* velocity_x = nullptr;
    const double* velocity_z = nullptr;
    const double* bed = nullptr;  ///< nx + 2
    int nx = 0;
    int nz = 0;
    double dx = 0.0;
    double dz = 0.0;
    double rate = 0.0;  ///< Stokes' drag, 1/s
    /// (d/ν)², which makes squares of Reynolds numbers of squares of velocities; 0 for Stokes' drag
    double reynolds_scale = 0.0;
    double gravity = 0.0;
    double time_step = 0.0;
};

/// Advances the first `count` lanes by `steps` steps (Terada 2025, figure 18, see grain_flight.h);
/// those that fill up their last vector fly on, too. Lanes that no longer fly stay as they are,
/// where they stopped.
void advance_stokes(GrainLanes& lanes, const LaneAir& air, int count, int steps);
void advance_schiller_naumann(GrainLanes& lanes, const LaneAir& air, int count, int steps);

}  // namespace fumon
