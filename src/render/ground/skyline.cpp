#include "render/ground/skyline.h"

#include <algorithm>
#include <cmath>

namespace fumon {

int rows_below_skyline(const std::vector<glm::vec3>& skyline, const Camera& camera, int rows) {
    if (!camera.perspective) return rows;
    constexpr int spare = 2;  // corners of the mesh are rounded, and samples look at neighbours
    const glm::dvec3 up = camera.up / camera.half.y;
    double highest = -1.0;  // of the picture's half height, from its middle
    for (const glm::vec3& direction : skyline) {
        const glm::dvec3 at(direction);
        const glm::dvec2 level(at);
        const double ahead = glm::dot(camera.forward, at);
        // Where this holds, what stands higher along a ray is seen higher in the picture.
        const bool upright = up.z * glm::dot(glm::dvec2(camera.forward), level) >
                             camera.forward.z * glm::dot(glm::dvec2(up), level);
        if (ahead <= 0.0 || !upright) return rows;
        highest = std::max(highest, glm::dot(up, at) / ahead);
    }
    const double below = std::ceil((0.5 + 0.5 * highest) * rows) + spare;
    return static_cast<int>(std::clamp(below, 0.0, static_cast<double>(rows)));
}

}  // namespace fumon
