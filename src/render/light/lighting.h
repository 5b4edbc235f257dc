#pragma once

#include "base/grid.h"
#include "render/light/light_texels.h"
#include "render/light/sun_sweep.h"
#include "render/view/display_bed.h"

namespace fumon {

class WorkerPool;
struct SunDirection;

/// The shares of sun and sky at every cell of a bed, the sun's within bounds.
struct LightShares {
    Field<float> sun;
    Field<float> sky;
    ShareBounds bounds{};
};

/// What the light does at every cell of a display bed, four 16-bit numbers a cell: the surface
/// normal's x and y (−1 … 1 on 0 … 65534), the share of the sun and the share of the sky (0 … 1).
/// Independent of the pool's size.
LightTexels lighting_texels(const DisplayBed& bed, const SunDirection& sun, WorkerPool& pool);

/// The same from known shares, without the cells of a margin on each side. The share of the sun
/// runs from its lowest to its highest bound.
LightTexels lighting_texels(const DisplayBed& bed, const LightShares& shares, int margin,
                            WorkerPool& pool);

}  // namespace fumon
