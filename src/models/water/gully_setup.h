#pragma once

#include <memory>

#include "models/sediment/sediment_loads.h"
#include "models/shared/model.h"
#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"
#include "models/water/water_maps.h"

namespace fumon {

/// What a gully run starts from, with every "auto" decided.
struct GullyStart {
    GullyParameters parameters;
    WaterDomain domain;
    bool on_terrain = false;  ///< the bed is a terrain file's
    Grid bed;
    Water water;
    Grid roughness;  ///< n, C or C_f of each cell; empty: the parameters' own
    Soil soil;
    std::vector<RainMap> rain_maps;  ///< by their times
};

/// Decides the "auto" values and lays out bed and water. Throws KeyError where parameters, bed and
/// edges do not go together, or nothing could ever move.
GullyStart start_of_gully(const GullyParameters& parameters, ModelSetup& setup);

/// What the water carries; null where the transport is not of loads.
std::unique_ptr<SedimentLoads> make_loads(const GullyStart& start, WorkerPool& pool);

/// The scheme that the parameters name. Throws KeyError where it cannot do the domain.
std::unique_ptr<ShallowWaterScheme> make_water_scheme(const GullyStart& start, WorkerPool& pool);

}  // namespace fumon
