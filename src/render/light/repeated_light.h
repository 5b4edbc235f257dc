#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/snapshot_lookup.h"
#include "render/light/avalanche_cells.h"
#include "render/light/light_texels.h"
#include "render/light/sun_sweep.h"
#include "render/view/block.h"
#include "render/view/drawn_origin.h"

namespace fumon {

class WorkerPool;

/// A periodic bed and what light and wind do to it, among its own repetitions; or a bed in its
/// plain.
struct RepeatedLight {
    Field<float> z;       ///< as the display bed's
    LightTexels texels;   ///< as lighting_texels; the sun's within `sun_bounds`
    LightTexels clamped;  ///< the same with the sun's share kept to 0 … 1
    /// Two of each cell, 0 … 255: how far ground upwind leaves the wind to it, and how far its sand
    /// lies as it slid: on slopes near the angle of repose, heights without exaggeration, and a
    /// cell around them; where the bed is not in metres, in the lee of a wind alone.
    std::vector<std::uint8_t> surface;
    AvalancheCells slid;
    bool walls = false;  ///< whether there are walls of rock, see with_straight_walls()
};

/// Bounds of the sun's share in RepeatedLight::texels.
inline constexpr ShareBounds sun_bounds{-15.0F, 16.0F};

/// `refinement`: see refinement_of. Cells count from `origin`. `way`: where the wind blows to; its
/// shadow falls at 10 to 15 degrees behind crests. Independent of the pool's size, and the same for
/// a bed shifted over its edges but for rounding.
RepeatedLight repeated_light(const Snapshot& snapshot, const Block& block, int refinement,
                             const DrawnOrigin& origin, const SunDirection& sun,
                             const HorizontalDirection& way, WorkerPool& pool);

}  // namespace fumon
