#include "film/camera/kept_clear.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "film/camera/camera_distance.h"
#include "render/view/camera.h"

namespace fumon {

namespace {

/// Whether points and a box lie on both sides of a line along which `across` is the same.
bool are_parted(const std::vector<glm::dvec2>& points, const PictureBox& box,
                const glm::dvec2& across) {
    const auto [least, most] = std::ranges::minmax(
        points, {}, [&](const glm::dvec2& point) { return glm::dot(point, across); });
    const glm::dvec2 middle = 0.5 * (box.low + box.high);
    const double reach = glm::dot(glm::abs(across), 0.5 * (box.high - box.low));
    const double at = glm::dot(middle, across);
    return glm::dot(least, across) > at + reach || glm::dot(most, across) < at - reach;
}

/// The corners of the convex hull of points, counterclockwise (Andrew 1979).
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
    std::ranges::sort(points, [](const glm::dvec2& one, const glm::dvec2& other) {
        return one.x != other.x ? one.x < other.x : one.y < other.y;
    });
    const auto turns_left = [](const glm::dvec2& from, const glm::dvec2& at, const glm::dvec2& to) {
        const glm::dvec2 one = at - from;
        const glm::dvec2 other = to - at;
        return one.x * other.y - one.y * other.x > 0.0;
    };
    std::vector<glm::dvec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const glm::dvec2& point : points) {
            while (hull.size() >= first + 2 &&
                   !turns_left(hull[hull.size() - 2], hull[hull.size() - 1], point))
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

/// Where the block's corners are seen in a picture.
std::vector<glm::dvec2> seen_corners(const FilmStage& stage, const CameraPose& pose) {
    const Camera camera = camera_of(stage, pose);
    std::vector<glm::dvec2> seen;
    for (const glm::dvec3& corner : block_corners(stage.block)) {
        const glm::dvec3 from = corner - camera.eye;
        const double depth = std::max(glm::dot(from, camera.forward), 1e-6);
        seen.emplace_back(glm::dot(from, camera.right) / (depth * camera.half.x),
                          glm::dot(from, camera.up) / (depth * camera.half.y));
    }
    return seen;
}

}  // namespace

bool hull_meets_box(const std::vector<glm::dvec2>& points, const PictureBox& box) {
    const std::array<glm::dvec2, 2> sides{{{1.0, 0.0}, {0.0, 1.0}}};
    if (std::ranges::any_of(sides,
                            [&](const glm::dvec2& side) { return are_parted(points, box, side); }))
        return false;
    const std::vector<glm::dvec2> hull = hull_of(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        if (are_parted(hull, box, {-edge.y, edge.x})) return false;
    }
    return true;
}

double clear_distance(const FilmStage& stage, const glm::dvec3& subject, double azimuth,
                      double elevation, double focal_length, double distance) {
    constexpr double step = 0.01;
    constexpr int most_steps = 50;
    const glm::dvec3 back = towards(azimuth, elevation);
    CameraPose pose;
    pose.look_at = subject;
    pose.focal_length = focal_length;
    for (int i = 0; i <= most_steps; ++i) {
        const double away = distance * (1.0 + step * i);
        pose.eye = subject + away * back;
        const std::vector<glm::dvec2> seen = seen_corners(stage, pose);
        if (std::ranges::none_of(stage.kept_clear,
                                 [&](const PictureBox& box) { return hull_meets_box(seen, box); }))
            return away;
    }
    return distance;
}

}  // namespace fumon
