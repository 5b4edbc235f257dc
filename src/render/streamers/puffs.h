#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/streamers/blown_sand.h"
#include "render/view/camera.h"
#include "render/view/tile_warp.h"

namespace fumon {

/// A cloud of sand whose density falls off as a normal law along each of three axes: one downwind,
/// one level across it, one across both.
struct Puff {
    glm::vec4 middle;  ///< from the eye, block lengths; and the density there, per block length
    glm::vec4 along;   ///< the first axis, a unit vector; and the spread along it
    glm::vec4 across;  ///< the other spreads; shares of sun and sky
};

/// How the ground lies that puffs are blown over.
struct PuffGround {
    glm::dvec2 corner{0.0};  ///< of the bed, from its middle, block lengths
    glm::dvec2 extent{1.0};
    double curvature = 0.0;
    TileWarp copies{};
};

/// The puffs that a camera sees of the sand over a bed and its repetitions, in an order of their
/// own. `strength`: see StreamerSettings; `gone`: how far the wind has
/// carried them since the first step, block lengths; `pixel`: the angle that one spans. A plume is
/// a train of puffs that leave the brink one after the other, go on downwind all equally fast,
/// sink, spread and thin out; gusts that pass along the brink leave dark gaps. Farther away fewer
/// and wider ones hold the same sand; where plumes are lower than a pixel there are none.
std::vector<Puff> visible_puffs(const BlownSand& sand, double strength, double gone,
                                const PuffGround& ground, const Camera& camera, double pixel);

}  // namespace fumon
