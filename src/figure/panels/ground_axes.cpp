#include "figure/panels/ground_axes.h"

#include <cmath>

namespace fumon {

CanvasPoint ViewProjection::at(const glm::dvec3& point) const {
    const glm::dvec2 seen = project(camera, point);
    return {picture.x + 0.5 * (1.0 + seen.x) * picture.width,
            picture.y + 0.5 * (1.0 - seen.y) * picture.height};
}

CanvasPoint ViewProjection::at_ground(const glm::dvec2& place, double z) const {
    return at({place.x / block.side - 0.5 * block.width_x,
               place.y / block.side - 0.5 * block.width_y, z});
}

GroundAxes visible_axes(const ViewProjection& view) {
    constexpr double step = 1e-4;  // block lengths
    const auto seen = [&](double x, double y) {
        const CanvasPoint ahead = view.at({x, y, view.block.surface});
        const CanvasPoint behind = view.at({-x, -y, view.block.surface});
        return glm::dvec2(ahead.x - behind.x, ahead.y - behind.y);
    };
    const glm::dvec2 east = seen(step, 0.0);
    const glm::dvec2 north = seen(0.0, step);
    // The longer half-axis of the ellipse that a circle of the ground becomes.
    const double sum = glm::dot(east, east) + glm::dot(north, north);
    const double area = east.x * north.y - east.y * north.x;
    const double longest =
        std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * area * area))));
    return {east / longest, north / longest};
}

}  // namespace fumon
