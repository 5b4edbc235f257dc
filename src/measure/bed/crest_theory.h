#pragma once

#include <limits>

#include "base/snapshot.h"
#include "measure/bed/crest_orientation.h"
#include "wind/crest_directions.h"

namespace fumon {

/// Crests measured beside those predicted, degrees clockwise from north; NaN for none.
struct CrestTheory {
    double measured = std::numeric_limits<double>::quiet_NaN();
    double gross_normal_transport = std::numeric_limits<double>::quiet_NaN();
    double bed_instability = std::numeric_limits<double>::quiet_NaN();
    double fingering = std::numeric_limits<double>::quiet_NaN();
};

/// What theories say of a snapshot's winds; γ is the flux ratio of crest_directions().
CrestDirections predicted_crests(const Snapshot& snapshot, double flux_ratio);

/// Of predicted directions that are equally favoured the one nearest to the crests.
CrestTheory crest_theory(const CrestOrientation& crests, const CrestDirections& predicted);

}  // namespace fumon
