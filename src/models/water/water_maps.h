#pragma once

#include <vector>

#include "models/shared/model.h"
#include "models/water/gully_parameters.h"
#include "models/water/infiltration.h"
#include "models/water/rain.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// Whether a scene maps a quantity.
bool has_map(const GullyParameters& parameters, MapQuantity quantity);

/// Throws KeyError where the maps of the parameters (`maps`, cell by cell) do not go together, say
/// what the parameters say too, lack values in cells of the domain, or have some out of range.
void check_maps(const GullyParameters& parameters, const WaterDomain& domain,
                const std::vector<CellMap>& maps);

/// Puts the depths, levels and velocities of the maps over the water that is there; where they have
/// no data it stays.
void fill_from_maps(const GullyParameters& parameters, const WaterDomain& domain, const Grid& bed,
                    const std::vector<CellMap>& maps, Water& water);

/// n, C or C_f of each cell; empty where no map says it.
Grid roughness_of(const GullyParameters& parameters, const WaterDomain& domain,
                  const std::vector<CellMap>& maps);

/// What the ground takes, cell by cell where maps say it; none outside the domain.
Soil soil_of(const GullyParameters& parameters, const WaterDomain& domain,
             const std::vector<CellMap>& maps);

/// The maps of rain, by their times; none falls outside the domain.
std::vector<RainMap> rain_maps_of(const GullyParameters& parameters, const WaterDomain& domain,
                                  const std::vector<CellMap>& maps);

}  // namespace fumon
