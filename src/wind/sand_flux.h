#pragma once

#include <vector>

#include "wind/flux/saturated_flux.h"
#include "wind/wind_rose.h"

namespace fumon {

/// Vector units of Fryberger & Dean (1979) of each wind: U² (U − U_t)/100 · t, with U and the
/// threshold U_t in knots, 10 m above the ground, and t in percent of the time. Winds below the
/// threshold move nothing and are left out.
std::vector<SandFlux> fryberger_fluxes(const WindRose& rose, double threshold_knots);

/// The height, in metres, of the speeds of a table that tells none.
inline constexpr double usual_speed_height = 10.0;

/// u* of a wind, m/s, whose speed is that at a height in metres where a table gives speeds.
double friction_velocity_of(const WindClass& wind, const SandAndAir& of, double height);

/// The sand that each wind moves in a year, in m² of bed (m³ over a metre's width), by the
/// saturated flux. What moves none is left out.
std::vector<SandFlux> saturated_fluxes(const WindRose& rose, const SandAndAir& of,
                                       double height = usual_speed_height);

}  // namespace fumon
