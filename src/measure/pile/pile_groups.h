#pragma once

#include "measure/shared/measure_group.h"

namespace fumon {

/// Grains, and the cone that the pile is.
MeasureGroup pile_group();
/// The last avalanche, and the sizes of all so far.
MeasureGroup avalanche_group();

}  // namespace fumon
