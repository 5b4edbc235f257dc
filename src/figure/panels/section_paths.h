#pragma once

#include "base/snapshot.h"
#include "figure/panels/axis_units.h"
#include "figure/plot/plot.h"

namespace fumon {

/// The shown paths of grains, in one colour per launch angle, over the height above the profile's
/// zero, to be drawn over the bed. `unit` is what lengths are shown in.
Plot paths_plot(const Snapshot& snapshot, const LengthUnit& unit);

}  // namespace fumon
