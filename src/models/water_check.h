#pragma once

#include "models/shallow_water.h"

namespace fumon {

class WorkerPool;

/// Throws Error where a depth is negative or a depth, velocity or bed height is not a finite
/// number: it names the first such cell, the quantity, the time (s) and what to try.
void check_water(const Water& water, const Grid& bed, double time, WorkerPool& pool);

}  // namespace fumon
