#pragma once

#include <vector>

#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// The stretches of edges of a grid that the parameters name, in the order written. Throws KeyError
/// where one lies outside its side, crosses an axis that is periodic, or has a table that is none.
std::vector<EdgeSegment> edge_segments_of(const GullyParameters& parameters,
                                          const WaterDomain& domain, int nx, int ny);

/// Puts the water of the regions that the parameters name over what is there. Throws KeyError where
/// one has both depth and level, or neither.
void fill_regions(const GullyParameters& parameters, const WaterDomain& domain, const Grid& bed,
                  Water& water);

/// Throws KeyError where rain_times and rain_rates are no staircase.
void check_rain(const GullyParameters& parameters);

}  // namespace fumon
