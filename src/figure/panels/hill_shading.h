#pragma once

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// How a flat map is shaded.
struct HillShading {
    SunSettings sun{};          ///< from the north-west
    double exaggeration = 1.0;  ///< vertical
    double strength = 1.0;      ///< 0: none … 1
    /// Light from four sides, from west to north-east by way of the sun's, so that no crest lies
    /// along the light; without shadows.
    bool from_all_sides = false;
};

/// By how much the light on each cell of a bed multiplies a colour's luminance: 1 on level, open
/// ground and the same as in a figure drawn by the renderer. In (0, 1].
Field<float> hill_light(const Snapshot& snapshot, const HillShading& shading, WorkerPool& pool);

}  // namespace fumon
