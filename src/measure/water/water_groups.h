#pragma once

#include "measure/shared/measure_group.h"

namespace fumon {

/// Channels, their course, and the bed of a single one.
MeasureGroup channel_group();
/// How uneven water and bed are.
MeasureGroup water_relief_group();
/// Fluxes, speeds and Froude numbers.
MeasureGroup water_flow_group();

}  // namespace fumon
