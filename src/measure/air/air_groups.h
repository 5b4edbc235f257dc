#pragma once

#include "measure/shared/measure_group.h"

namespace fumon {

/// Speed, divergence, eddy and pressure of the air in a section.
MeasureGroup air_group();
/// The bed's shear stress beside the bed.
MeasureGroup stress_group();
/// Flight lengths, a column for each curve "flight_length_…" that a snapshot has.
MeasureGroup flight_group(const Snapshot& first);

}  // namespace fumon
