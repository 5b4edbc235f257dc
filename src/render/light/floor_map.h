#pragma once

#include <cstdint>
#include <vector>

#include "render/light/sun_sweep.h"
#include "render/view/block.h"
#include "render/view/display_bed.h"

namespace fumon {

class WorkerPool;

/// How the first bed's block darkens the plain it stands on: the share of the sun and of the sky
/// that reaches each cell of a square around its centre.
struct FloorMap {
    static constexpr int cells = 512;           ///< along each side
    static constexpr double half_width = 1.35;  ///< of the square, in block lengths
    std::vector<std::uint8_t> sun_and_sky;      ///< two bytes a cell, 0 … 255
};

/// `half_width`: of the source along the horizon to either side, radians; 0: shadows are soft away
/// from it alone.
FloorMap floor_map(const DisplayBed& bed, const Block& block, const SunDirection& sun,
                   WorkerPool& pool, double half_width = 0.0);

/// Of no block.
FloorMap open_floor();

}  // namespace fumon
