#pragma once

#include <memory>

#include "models/shared/model.h"
#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// What a gully run starts from, with every "auto" decided.
struct GullyStart {
    GullyParameters parameters;
    WaterDomain domain;
    bool on_terrain = false;  ///< the bed is a terrain file's
    Grid bed;
    Water water;
};

/// Decides the "auto" values and lays out bed and water. Throws KeyError where parameters, bed and
/// edges do not go together, or nothing could ever move.
GullyStart start_of_gully(const GullyParameters& parameters, ModelSetup& setup);

/// The scheme that the parameters name. Throws KeyError where it cannot do the domain.
std::unique_ptr<ShallowWaterScheme> make_water_scheme(const GullyStart& start, WorkerPool& pool);

}  // namespace fumon
