#pragma once

#include <span>
#include <vector>

#include "models/air/air_plane.h"

namespace fumon {

/// The shear stress τ = ρν (∂u/∂z + ∂w/∂x) at the bed of each column, Pa, from velocities at the
/// nodes (Terada 2025, eqs. 37–40): extrapolated linearly to z = h from the first node at or above
/// the bed and the one over it. Differences in x at the first node leave out neighbours inside the
/// bed; where both are, that term is 0.
std::vector<double> staircase_stress(const AirPlane& plane, std::span<const double> u,
                                     std::span<const double> w, double dynamic_viscosity);

}  // namespace fumon
