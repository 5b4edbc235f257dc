#pragma once

#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// The largest (|u| + √(g h)) / dx + (|v| + √(g h)) / dy, 1/s: times a sub-step, its Courant
/// number. 0 where all is dry; cells whose values are not numbers are passed over.
double courant_rate(const Water& water, double dx, double dy, double gravity, WorkerPool& pool);

}  // namespace fumon
