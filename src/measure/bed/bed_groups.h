#pragma once

#include "measure/shared/measure_group.h"

namespace fumon {

/// Mean, spread and extremes of the heights, and their sum.
MeasureGroup statistics_group();
/// The three wavelengths and the two heights of waves.
MeasureGroup wave_group();
/// Celerity since the row before.
MeasureGroup celerity_group();
MeasureGroup slope_group();
/// Orientation and defects of crests.
MeasureGroup crest_group();
/// Separate dunes.
MeasureGroup dune_group();

}  // namespace fumon
