#pragma once

#include "models/dunes/setup/dunes_parameters.h"
#include "wind/flux/saturated_flux.h"

namespace fumon {

/// The sand and the ground by which speeds of winds become fluxes.
SandAndAir sand_and_air_of(const DunesParameters& parameters);

/// The parameters with a strength and a threshold ratio for each wind that they give by a speed or
/// a friction velocity u*: strength × model.flux is the saturated flux in m²/yr (yearly_flux), and
/// a threshold_ratio of "auto" is u*/u*t where the model knows a threshold, else "none". Winds up
/// to the threshold are calms, of strength 0. Winds given by their strength stay as they are, with
/// "none" for "auto". Throws KeyError for a wind that is given twice, a height of speeds within the
/// ground's roughness, and a calm of slabs, whose steps would never end.
DunesParameters with_wind_strengths(const DunesParameters& parameters);

/// The strength by which steps are short enough for all winds: of at least 1, unless speeds or
/// friction velocities give all of them.
double strongest_wind(const DunesParameters& parameters);

}  // namespace fumon
