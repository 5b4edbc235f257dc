#pragma once

#include "base/grid.h"
#include "models/sand/sand_parameters.h"

namespace fumon {

/// The saltation flux over each cell of a bed by the hops of SandParameters, what leaves it in a
/// step times how far that hops,
///
///     Φ = q L,
///
/// in parts of that over level sand at the bed's mean height. Hops of the random-sequential order
/// count as if each cell hopped once.
Grid saltation_flux(const SandParameters& parameters, const Grid& bed);

}  // namespace fumon
