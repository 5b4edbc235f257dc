#pragma once

#include <span>
#include <vector>

#include "base/snapshot.h"
#include "wind/wind_rose.h"

namespace fumon {

/// The sand that each wind of a run moves over flat ground, m²/yr on the mean over the whole time.
std::vector<SandFlux> fluxes_of(std::span<const SnapshotWind> winds);

}  // namespace fumon
