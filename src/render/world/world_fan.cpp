#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "render/world/world_layer.h"

namespace fumon {

namespace {

constexpr double nearest_share = 0.2;    // of the eye's height above the ground: the first ring
constexpr double least_nearest = 1e-6;   // block lengths
constexpr double earth_radius = 6360.0;  // km
constexpr double pixels_per_ray = 3.0;
constexpr double wall_slope = 1.2;    // twice that of sand
constexpr double longest_turn = 0.3;  // of a ripple, between two samples, at which it is not seen

/// How far a camera's rays within `half` of its axis turn aside, and how far they run, seen from
/// above, while they sink by 1, at least.
struct Reach {
    double half_angle = 0.0;
    double least_run = 1e3;
};

Reach reach_of(const Camera& camera, const glm::dvec2& heading, const glm::dvec2& half) {
    Reach reach;
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            const glm::dvec3 ray =
                camera.forward + x * half.x * camera.right + y * half.y * camera.up;
            const glm::dvec2 flat(ray.x, ray.y);
            if (ray.z < 0.0)
                reach.least_run = std::min(reach.least_run, glm::length(flat) / -ray.z);
            const double along = glm::dot(flat, heading);
            const double across = heading.x * flat.y - heading.y * flat.x;
            reach.half_angle =
                std::max(reach.half_angle, std::abs(elementary::atan2(across, along)));
        }
    }
    return reach;
}

}  // namespace

double WorldLayer::ground_at(const glm::dvec2& position, const HeightPyramid& heights) const {
    Camera there;
    there.eye = glm::dvec3(position, 0.0);
    return ground_under(there, heights);
}

double WorldLayer::ground_under(const Camera& camera, const HeightPyramid& heights) const {
    const glm::dvec3 eye = reduced_eye(camera);
    const WarpedGround copy = copies_.at(glm::dvec2(camera.eye));
    const auto on_bed =
        static_cast<double>(heights.at(0, eye.x / block_.width_x + 0.5 + copy.offset.x,
                                       eye.y / block_.width_y + 0.5 + copy.offset.y));
    return copies_.raised(copy, on_bed);
}

/// As wide as the picture's corners reach, all around where it looks down on itself; from the
/// ground under the camera to where the planet's curvature hides the highest crests.
GroundFan WorldLayer::fan_of(const Camera& camera, const HeightPyramid& heights) const {
    GroundFan fan;
    const glm::dvec2 level(camera.forward.x, camera.forward.y);
    const double length = glm::length(level);
    if (length > 1e-6) fan.heading = level / length;
    const auto turned_aside = [&](double angle) {
        return angle > 1.4 ? std::numbers::pi : angle * 1.02 + 0.01;
    };
    Reach reach = reach_of(camera, fan.heading, camera.half);
    fan.half_angle = turned_aside(reach.half_angle);
    const double above = camera.eye.z - ground_under(camera, heights);
    fan.nearest = std::max(nearest_share * above, least_nearest);
    fan.rays = static_cast<int>(static_cast<double>(view_.image.width) / pixels_per_ray) + 2;
    if (camera.lens.radius > 0.0) {
        // As wide as its points see, with rays as close together.
        const double nearest = std::max(fan.nearest, 0.5 * above * reach.least_run);
        const double blur = camera.lens.radius * (1.0 / camera.lens.focus + 1.0 / nearest);
        reach = reach_of(camera, fan.heading, camera.half + blur);
        const double before = std::exchange(fan.half_angle, turned_aside(reach.half_angle));
        fan.rays = static_cast<int>(std::ceil(fan.rays * fan.half_angle / before));
        fan.lens = camera.lens.radius;
    }
    // Where the whole bed lies under the eye, nothing nearer than the steepest ray's foot is seen.
    const auto highest = static_cast<double>(heights.highest());
    if (fan.half_angle < std::numbers::pi)
        fan.nearest =
            std::max(fan.nearest, 0.9 * (camera.eye.z - fan.lens - highest) * reach.least_run);
    const double twice_radius = 2.0 * earth_radius / block_.kilometres;
    const auto horizon = [&](double height) {
        return std::sqrt(std::max(height, 0.0) * twice_radius);
    };
    const double lowest = block_.surface - (highest - block_.surface);
    fan.farthest = std::max(1.1 * (horizon(camera.eye.z - lowest) + horizon(highest - lowest)),
                            1e3 * fan.nearest);
    fan.eye = reduced_eye(camera);
    fan.extent = glm::dvec2(block_.width_x, block_.width_y);
    fan.cell = static_cast<double>(cell_);
    if (heights.has_walls()) fan.wall_slope = wall_slope * block_.exaggeration;
    fan.curvature = static_cast<double>(curvature());
    fan.strength = copies_.strength();
    fan.eye_from_middle = eye_from_middle(camera);
    fan.mean = copies_.mean();
    return fan;
}

glm::dvec3 WorldLayer::reduced_eye(const Camera& camera) const {
    if (block_.tiles.plain) return camera.eye;
    const auto reduced = [](double position, double extent) {
        return position - extent * std::floor(position / extent + 0.5);
    };
    return {reduced(camera.eye.x - origin_.position.x, block_.width_x),
            reduced(camera.eye.y - origin_.position.y, block_.width_y), camera.eye.z};
}

glm::dvec2 WorldLayer::eye_from_middle(const Camera& camera) const {
    const glm::dvec2 extent(block_.width_x, block_.width_y);
    const glm::dvec2 whole = glm::floor((glm::dvec2(camera.eye) - origin_.position) / extent + 0.5);
    return copies_.from_middle(origin_.share + whole, glm::dvec2(reduced_eye(camera)) / extent);
}

Camera WorldLayer::at_origin(const Camera& camera, const GroundFan& fan) {
    Camera there = camera;
    there.eye = glm::dvec3(0.0);
    there.near_depth = 0.5 * fan.nearest;
    there.far_depth = fan.farthest * 1.1;
    return there;
}

glm::mat4 WorldLayer::clip_from_eye(const Camera& camera) const {
    return {clip_matrix(at_origin(camera, fan_of(camera, *heights_)))};
}

float WorldLayer::curvature() const {
    return static_cast<float>(block_.kilometres / (2.0 * earth_radius));
}

VisibleGround WorldLayer::visible_ground(const Camera& camera, double samples_high,
                                         const HeightPyramid& heights, WorkerPool& pool) const {
    VisibleGround ground;
    ground.sample_angle = 2.0 * camera.half.y / samples_high;
    // Beyond that distance a sample spans too much of a ripple.
    ground.near_limit = 2.0 * longest_turn * ripple_wavelength_ / ground.sample_angle;
    GroundFan fan = fan_of(camera, heights);
    fan.near_limit = ground.near_limit;
    ground.mesh = ground_mesh(fan, heights, pool);
    return ground;
}

}  // namespace fumon
