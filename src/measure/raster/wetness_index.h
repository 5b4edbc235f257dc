#pragma once

#include "measure/network/flow_routing.h"

namespace fumon {

/// Slopes below this count as so steep in the wetness index, which has no value on level ground.
inline constexpr double least_wetness_slope = 0.001;

/// The topographic wetness index ln(a / tan β) of each cell (Beven & Kirkby 1979). a is the area
/// that drains through the cell over the side of a square cell of its area, √(dx·dy), in the unit
/// of dx; tan β is `slope`, at least `least_wetness_slope`. 0 where no area drains: without data.
Grid wetness_index(const FlowRouting& routing, const Grid& slope);

}  // namespace fumon
