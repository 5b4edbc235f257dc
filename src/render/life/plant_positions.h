#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"
#include "render/view/block.h"

namespace fumon {

/// The kinds of plants of model dunes.
enum class PlantKind : std::uint8_t { grass, shrub };

/// One plant of a bed, in block lengths from the bed's south-west corner.
struct Plant {
    glm::vec2 position{0.0F};
    float height = 0.0F;
    float turn = 0.0F;  ///< radians, about the vertical
    float rank = 0.0F;  ///< 0 … 1, by chance: where fewer are drawn, those of low rank are
    PlantKind kind = PlantKind::grass;
};

/// Plants as the fields "grass" and "shrubs" cover the cells (0 … 1), `share` of them: each stands
/// at a point of its own, which chance gave it, and comes up where the cover is greater than its
/// own threshold, so that from frame to frame plants grow and wither where they are. They grow to
/// Snapshot::grass_height and shrub_height; without metres a cell counts as one. Row by row; none
/// where there are no such fields.
std::vector<Plant> plant_positions(const Snapshot& snapshot, const Block& block, double share);

}  // namespace fumon
