#include "film/camera/camera_distance.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"

namespace fumon {

namespace {

constexpr double half_lens_millimetres = 12.0;  // mm
constexpr double least_distance = 0.05;         // block lengths

/// Whether a place of the block is ground with data.
bool is_ground(const FilmStage& stage, const Snapshot& bed, const glm::dvec3& at) {
    const double x = at.x / stage.block.width_x + 0.5;
    const double y = at.y / stage.block.width_y + 0.5;
    if (!(x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0)) return false;
    return bed.nodata.empty() ||
           bed.nodata(static_cast<int>(x * bed.bed.nx()), static_cast<int>(y * bed.bed.ny())) == 0;
}

}  // namespace

glm::dvec3 towards(double azimuth, double elevation) {
    const double c = elementary::cos(elevation * degree);
    return {elementary::sin(azimuth * degree) * c, elementary::cos(azimuth * degree) * c,
            elementary::sin(elevation * degree)};
}

double fit_distance(const FilmStage& stage, const glm::dvec3& subject, double azimuth,
                    double elevation, double focal_length) {
    const glm::dvec3 back = towards(azimuth, elevation);
    const glm::dvec3 right(-elementary::cos(azimuth * degree), elementary::sin(azimuth * degree),
                           0.0);
    const glm::dvec3 up = glm::cross(back, right);
    const double room = 1.0 - 2.0 * stage.scene.view.camera.margin;
    const double narrow = room * half_lens_millimetres / focal_length;
    const double half_x = narrow * std::max(1.0, stage.aspect) * (1.0 + stage.overrun);
    const double half_y = narrow * std::max(1.0, 1.0 / stage.aspect);
    double least = least_distance;
    for (const glm::dvec3& corner : block_corners(stage.block)) {
        const glm::dvec3 from = corner - subject;
        const double nearer = glm::dot(from, back);
        least = std::max({least, std::abs(glm::dot(from, right)) / half_x + nearer,
                          std::abs(glm::dot(from, up)) / half_y + nearer});
    }
    return least;
}

double ground_share(const FilmStage& stage, const Snapshot& bed, const CameraPose& pose) {
    constexpr int looks = 40;  // along each side of the picture
    const Camera camera = camera_of(stage, pose);
    int seen = 0;
    for (int j = 0; j < looks; ++j) {
        for (int i = 0; i < looks; ++i) {
            const glm::dvec2 at((2.0 * i + 1.0) / looks - 1.0, (2.0 * j + 1.0) / looks - 1.0);
            const glm::dvec3 ray = camera.forward + at.x * camera.half.x * camera.right +
                                   at.y * camera.half.y * camera.up;
            if (ray.z >= 0.0) continue;
            const double way = (stage.block.surface - camera.eye.z) / ray.z;
            if (way > 0.0 && is_ground(stage, bed, camera.eye + way * ray)) ++seen;
        }
    }
    return static_cast<double>(seen) / (looks * looks);
}

double fill_distance(const FilmStage& stage, const Snapshot& bed, CameraPose pose, double azimuth,
                     double elevation) {
    constexpr int halvings = 12;
    const glm::dvec3 back = towards(azimuth, elevation);
    double far = fit_distance(stage, pose.look_at, azimuth, elevation, pose.focal_length);
    double near = least_distance;
    const auto fills = [&](double away) {
        pose.eye = pose.look_at + away * back;
        return ground_share(stage, bed, pose) >= filled_share;
    };
    if (fills(far)) return far;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (near + far);
        (fills(middle) ? near : far) = middle;
    }
    return near;
}

double near_distance(double breadth, double focal_length) {
    return std::max(least_distance, breadth * focal_length / half_lens_millimetres);
}

}  // namespace fumon
