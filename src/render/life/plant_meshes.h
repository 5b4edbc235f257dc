#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/life/plant_positions.h"

namespace fumon {

/// A corner of a leaf of a plant that is 1 high and stands at the origin.
struct LeafVertex {
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    float tint = 0.0F;  ///< −1 … 1: of dry leaves, of green ones
};

/// How finely a plant is drawn, by the pixels that it is high.
enum class PlantDetail : int { near, middle, far };
inline constexpr int plant_details = 3;

/// Triangles, three corners each: a tuft of bent blades, or twigs with leaves around them. The same
/// each time.
std::vector<LeafVertex> plant_mesh(PlantKind kind, PlantDetail detail);

}  // namespace fumon
