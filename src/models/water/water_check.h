#pragma once

#include <string>

#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// Throws Error where a depth is negative or a depth, velocity or bed height is not a finite
/// number: it names the first such cell, the quantity, the time (s) and what to try.
void check_water(const Water& water, const Grid& bed, double time, WorkerPool& pool);

/// Throws the Error that the flow has become too fast to follow: it names the fastest cell, its
/// speed, and `reason`, which says what that asks of the sub-steps.
[[noreturn]] void refuse_speed(const Water& water, double time, const std::string& reason);

}  // namespace fumon
