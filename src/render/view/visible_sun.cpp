#include "render/view/visible_sun.h"

#include <algorithm>
#include <cmath>

namespace fumon {

namespace {

constexpr int columns = 9;  // of the disc

/// The tangent of the angle above the horizon at which the highest ground is seen that way, as far
/// as it is above `least`.
double skyline(const glm::dvec3& eye, const glm::dvec2& way, const RayGround& ground,
               double curvature, double least, double enough) {
    double highest = least;
    double away = ground.step;
    while (away < ground.farthest && highest < enough && eye.z + away * highest <= ground.highest) {
        const double z = ground.height(glm::dvec2(eye) + away * way) - curvature * away * away;
        highest = std::max(highest, (z - eye.z) / away);
        away += ground.step + ground.growth * away;
    }
    return highest;
}

}  // namespace

double visible_sun_share(const Camera& camera, const glm::dvec3& to_sun, const RayGround& ground,
                         double curvature) {
    if (!camera.perspective || glm::dot(camera.forward, to_sun) <= 0.0) return 1.0;
    const double level = std::max(glm::length(glm::dvec2(to_sun)), 1e-6);
    const glm::dvec2 way = glm::dvec2(to_sun) / level;
    const glm::dvec2 aside(-way.y, way.x);
    const double middle = to_sun.z / level;
    const double by_angle = disc_radius * (1.0 + middle * middle);  // of the tangent, over a radius
    double visible_sun = 0.0;
    double all = 0.0;
    for (int i = 0; i < columns; ++i) {
        const double x = (2.0 * i + 1.0) / columns - 1.0;
        const double chord = std::sqrt(1.0 - x * x);
        const double low = middle - by_angle * chord;
        const double high = middle + by_angle * chord;
        const double azimuth = x * disc_radius / level;
        const double at = skyline(camera.eye, glm::normalize(way + azimuth * aside), ground,
                                  curvature, low, high);
        visible_sun += chord * std::clamp((high - at) / (high - low), 0.0, 1.0);
        all += chord;
    }
    return visible_sun / all;
}

}  // namespace fumon
