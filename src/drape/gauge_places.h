#pragma once

#include "scene/initial_bed.h"
#include "scene/scene.h"
#include "scene/view/layers.h"

namespace fumon {

/// The points and lines of a scene's [[gauge]] over its bed; sides are left out. Their names are
/// labels where the layer has any. Nothing of a gauge beside the bed, or in coordinates of a map
/// that the bed does not have: the model refuses these.
PlacedLayer placed_gauges(const Scene& scene, const LayerSettings& layer,
                          const InitialBed& initial);

}  // namespace fumon
