#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "base/snapshot.h"

namespace fumon {

/// What the winds of a run move over flat sand, m²/yr: DP, RDP and where that points (degrees
/// clockwise from north, null where nothing moves on balance) as "drift_potential",
/// "resultant_drift_potential" and "resultant_drift_direction", and under "winds" for each of them
/// where it blows "toward" and its "flux" on the mean over the whole time, of which DP is the sum.
nlohmann::ordered_json drift_json(std::span<const SnapshotWind> winds);

}  // namespace fumon
