#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace fumon {

/// A corner of a person's surface: metres, from the ground between the heels; looking along +y, x
/// to the right.
struct PersonVertex {
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    glm::vec3 colour{0.5F};  ///< reflectances
};

inline constexpr double person_height = 1.75;  // metres

/// A walker of that height, one foot before the other: triangles, three corners each. The same each
/// time.
std::vector<PersonVertex> person_mesh();

}  // namespace fumon
