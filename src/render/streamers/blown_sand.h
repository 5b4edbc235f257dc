#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"
#include "base/snapshot_lookup.h"
#include "render/light/sun_sweep.h"
#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

/// Throws KeyError where a view asks for streamers that such beds have not: where no wind moves
/// sand, of a single row, where the ground is a block with sides.
void check_streamers(const View& view, const Snapshot& first);

/// A cell over whose brink sand leaves into the lee.
struct Brink {
    glm::dvec2 position{0.0};  ///< from the bed's south-western corner, block lengths
    double z = 0.0;            ///< likewise
    double flux = 0.0;         ///< in parts of that over level ground
    glm::vec3 sun{1.0F};       ///< shares of the sun at the plume's begin, middle and end
    std::uint32_t id = 0;
};

/// The sand that the wind blows over a bed, as streamers show it. Lengths are the block's.
struct BlownSand {
    HorizontalDirection way;  ///< where the wind of the step blows to
    double metre = 1.0;       ///< without metres what a cell is 2.5 of
    double length = 0.0;      ///< of plumes
    double travel = 0.0;      ///< downwind in a step
    double width = 0.0;       ///< of a cell, across the wind
    std::vector<Brink> brinks;
    Field<float> z;     ///< of cells
    Field<float> open;  ///< flux where the wind reaches the ground
    Field<float> sun;   ///< share of the sun there
    bool repeats = false;
};

/// Of a snapshot as it is shown. A brink is where the flux leaves ground that the wind reaches for
/// ground in the shadow that it casts at 10 to 15 degrees: as much as that shadow grows over a cell
/// leaves there. Independent of the pool's size.
BlownSand blown_sand(const Snapshot& snapshot, const View& view, const Block& block,
                     const SunDirection& sun);

}  // namespace fumon
