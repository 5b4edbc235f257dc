#pragma once

#include <optional>

#include "base/grid.h"

namespace fumon {

/// The level of the sea into which a surface runs out: its edge's lowest height, where a fifth of
/// it at least lies there, and a fifth of what is some cells within, so that neither a stream, nor
/// a row of equal heights, nor a reservoir at a corner is taken for one. `depth`: how many cells
/// each lies within; 0 outside.
std::optional<double> sea_level(const Grid& surface, const Field<float>& depth, double tolerance);

}  // namespace fumon
