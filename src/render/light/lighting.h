#pragma once

#include <cstdint>
#include <vector>

#include "render/view/display_bed.h"

namespace fumon {

class WorkerPool;
struct SunDirection;

/// What the light does at every cell of a display bed, four 16-bit numbers a cell: the surface
/// normal's x and y (−1 … 1 on 0 … 65534), the share of the sun and the share of the sky (0 … 1).
/// Cells of a margin shade, but have no texels. Independent of the pool's size.
std::vector<std::uint16_t> lighting_texels(const DisplayBed& bed, const SunDirection& sun,
                                           int margin, WorkerPool& pool);

}  // namespace fumon
