#include "render/view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

namespace {

constexpr double turn_step =
    3.0;  // degrees between the azimuths at which a turning block is fitted
constexpr double steep_view = 60.0;  // degrees: seen from higher up, every block is fitted

/// Turns a camera about its axis, to the right.
void roll(Camera& camera, double degrees) {
    if (degrees == 0.0) return;
    const double c = elementary::cos(degrees * degree);
    const double s = elementary::sin(degrees * degree);
    const glm::dvec3 right = camera.right;
    camera.right = c * right - s * camera.up;
    camera.up = c * camera.up + s * right;
}

/// Sets the three directions of a camera that stands at an azimuth and elevation.
void aim(Camera& camera, double azimuth, double elevation, double rolled) {
    const double sin_a = elementary::sin(azimuth * degree);
    const double cos_a = elementary::cos(azimuth * degree);
    const double sin_e = elementary::sin(elevation * degree);
    const double cos_e = elementary::cos(elevation * degree);
    camera.forward = -glm::dvec3(sin_a * cos_e, cos_a * cos_e, sin_e);
    camera.right = glm::dvec3(-cos_a, sin_a, 0.0);
    camera.up = glm::cross(camera.right, camera.forward);
    roll(camera, rolled);
}

/// A point along the camera's own axes: right, up, forward.
glm::dvec3 along_axes(const Camera& camera, const glm::dvec3& point) {
    return {glm::dot(point, camera.right), glm::dot(point, camera.up),
            glm::dot(point, camera.forward)};
}

glm::dvec3 centre(const Block& block) {
    return {0.0, 0.0, 0.5 * (block.base + block.top)};
}

/// The block's corners along the axes of every camera of the turn.
std::vector<glm::dvec3> corners_over_turn(const CameraSettings& settings, const Block& block) {
    std::vector<glm::dvec3> points;
    const int count =
        1 + static_cast<int>(std::ceil(std::min(std::abs(settings.turn), 360.0) / turn_step));
    for (int i = 0; i < count; ++i) {
        Camera turned;
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        const double turn = std::clamp(settings.turn, -360.0, 360.0);
        aim(turned, settings.azimuth + share * turn, settings.elevation, settings.roll);
        for (const glm::dvec3& corner : block_corners(block))
            points.push_back(along_axes(turned, corner));
    }
    return points;
}

/// The eye (along the camera's axes) nearest to points seen under |x| ≤ half.x·depth and
/// |y| ≤ half.y·depth. On each axis the points bound two lines; the eye lies where they cross.
glm::dvec3 fitted_eye(const std::vector<glm::dvec3>& points, const glm::dvec2& half) {
    double depth = std::numeric_limits<double>::max();
    glm::dvec2 eye(0.0);
    for (int axis = 0; axis < 2; ++axis) {
        double most = std::numeric_limits<double>::lowest();
        double least = std::numeric_limits<double>::max();
        for (const glm::dvec3& point : points) {
            most = std::max(most, point[axis] - half[axis] * point.z);
            least = std::min(least, point[axis] + half[axis] * point.z);
        }
        depth = std::min(depth, (least - most) / (2.0 * half[axis]));
        eye[axis] = 0.5 * (least + most);
    }
    return {eye, depth};
}

void fit_perspective(Camera& camera, const CameraSettings& settings, const Block& block) {
    const glm::dvec2 usable = camera.half * (1.0 - 2.0 * settings.margin);
    const glm::dvec3 eye = fitted_eye(corners_over_turn(settings, block), usable);
    camera.eye = eye.x * camera.right + eye.y * camera.up + eye.z * camera.forward;
}

void fit_orthographic(Camera& camera, const CameraSettings& settings, const Block& block,
                      double aspect) {
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& point : corners_over_turn(settings, block)) {
        low = glm::min(low, glm::dvec2(point));
        high = glm::max(high, glm::dvec2(point));
    }
    const glm::dvec2 extent = 0.5 * (high - low) / (1.0 - 2.0 * settings.margin);
    const double half_height = std::max(extent.y, extent.x / aspect);
    camera.half = {half_height * aspect, half_height};
    const glm::dvec2 middle = 0.5 * (low + high);
    camera.eye = middle.x * camera.right + middle.y * camera.up - 3.0 * camera.forward;
}

/// Moves a camera to which a block is fitted nearer, where land goes on around the block: what lies
/// nearer than the block is not seen, or as little as its breadth allows. Among
/// mountains the camera stays as high as the highest of them, so that it does not stand before a
/// wall.
void stand_before(Camera& camera, const Block& block) {
    const glm::dvec3 middle(0.0, 0.0, block.surface);
    const double fitted = glm::dot(middle - camera.eye, camera.forward);
    const glm::dvec2 toward = -glm::normalize(glm::dvec2(camera.forward));
    const glm::dvec2 aside(camera.right);
    double reach = 0.0;
    double breadth = 0.0;
    for (const glm::dvec2& point : block.outline) {
        reach = std::max(reach, glm::dot(point, toward));
        breadth = std::max(breadth, std::abs(glm::dot(point, aside)));
    }
    double distance = breadth / camera.half.x;
    const glm::dvec3 lowest = camera.forward - camera.half.y * camera.up;
    if (lowest.z < 0.0) {
        const double ahead = glm::dot(glm::dvec2(lowest), toward) / lowest.z;  // of a fall of 1
        const double nearer =
            -glm::dot(glm::dvec2(camera.forward), toward) + camera.forward.z * ahead;
        if (nearer > 0.0) distance = std::min(distance, reach / nearer);
    }
    const double over_all = (block.top - block.surface) / -camera.forward.z;
    distance = std::max(distance, block.rock * std::min(over_all, fitted));
    camera.eye = middle - distance * camera.forward;
}

/// Puts a camera at a place, or lets it look at one.
void stand(Camera& camera, const CameraSettings& settings, const Block& block) {
    const glm::dvec3 target = block.look_at.value_or(centre(block));
    if (!block.eye) {
        const double distance = settings.distance.is_word() ? 1.0 : settings.distance.value;
        camera.eye = target - distance * camera.forward;
        return;
    }
    camera.eye = *block.eye;
    camera.focus = 0.1;
    if (!block.look_at) return;
    const glm::dvec3 toward = target - camera.eye;
    const double distance = glm::length(toward);
    if (distance < 1e-9) return;
    camera.focus = distance;
    camera.forward = toward / distance;
    const double level = elementary::hypot(toward.x, toward.y);
    const bool upright = level > 1e-9 * distance;
    if (upright) camera.right = glm::dvec3(toward.y / level, -toward.x / level, 0.0);
    camera.up = glm::cross(camera.right, camera.forward);
    if (upright) roll(camera, settings.roll);
}

void set_depths(Camera& camera, const Block& block) {
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& corner : block_corners(block)) {
        const double depth = glm::dot(corner - camera.eye, camera.forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    // Later beds may stand higher than the framed one.
    const double room = 0.25 * (farthest - nearest);
    constexpr double tall = 2.0;  // block lengths; nothing is lost by it without perspective
    const double least = block.eye ? 1e-3 : 0.02;
    camera.near_depth = camera.perspective ? std::max(nearest - room, least) : nearest - tall;
    camera.far_depth = std::max(farthest + room, camera.near_depth + 0.1);
}

}  // namespace

std::vector<glm::dvec3> block_corners(const Block& block) {
    std::vector<glm::dvec3> corners;
    corners.reserve(2 * block.outline.size());
    for (const glm::dvec2& point : block.outline) {
        corners.emplace_back(point, block.base);
        corners.emplace_back(point, block.top);
    }
    return corners;
}

Camera place_camera(const CameraSettings& settings, const Block& block, double aspect,
                    double progress) {
    CameraSettings used = settings;
    if (settings.projection == Projection::map) {
        used.azimuth = 180.0;
        used.elevation = 90.0;
        used.turn = 0.0;
    }
    Camera camera;
    camera.perspective = settings.projection == Projection::perspective;
    if (!camera.perspective) used.roll = 0.0;
    aim(camera, used.azimuth + used.turn * progress, used.elevation, used.roll);
    const double half_angle = 0.5 * used.field_of_view * degree;
    constexpr double half_film = 12.0;  // mm
    const double tangent = used.focal_length.is_word()
                               ? elementary::sin(half_angle) / elementary::cos(half_angle)
                               : half_film / used.focal_length.value;
    camera.focal_length = half_film / tangent;
    camera.half = {tangent * aspect, tangent};
    if (block.eye || block.look_at) {
        stand(camera, used, block);
    } else if (!used.distance.is_word()) {
        camera.eye = centre(block) - used.distance.value * camera.forward;
        if (!camera.perspective) camera.half *= used.distance.value;
    } else if (camera.perspective && block.goes_on && used.distance.word == "auto" &&
               used.turn == 0.0 && used.elevation < steep_view) {
        fit_perspective(camera, used, block);
        stand_before(camera, block);
    } else if (camera.perspective) {
        fit_perspective(camera, used, block);
    } else {
        fit_orthographic(camera, used, block, aspect);
    }
    if (!block.eye) camera.focus = -glm::dot(camera.eye, camera.forward);
    set_depths(camera, block);
    return camera;
}

glm::dmat4 clip_matrix(const Camera& camera) {
    const double n = camera.near_depth;
    const double f = camera.far_depth;
    const glm::dvec3 x = camera.right / camera.half.x;
    const glm::dvec3 y = camera.up / camera.half.y;
    glm::dmat4 rows(0.0);  // row-major here, transposed on return
    const auto row = [&](const glm::dvec3& direction, double offset) {
        return glm::dvec4(direction, offset - glm::dot(direction, camera.eye));
    };
    rows[0] = row(x, 0.0);
    rows[1] = row(y, 0.0);
    if (camera.perspective) {
        rows[2] = row(camera.forward * ((f + n) / (f - n)), -2.0 * f * n / (f - n));
        rows[3] = row(camera.forward, 0.0);
        const Lens& lens = camera.lens;
        if (lens.radius > 0.0) {
            const glm::dvec2 off = lens.point / camera.half;
            const glm::dvec2 sheared = off / lens.focus + lens.aside;
            rows[0] += row(camera.forward * sheared.x, -off.x);
            rows[1] += row(camera.forward * sheared.y, -off.y);
        }
    } else {
        rows[2] = row(camera.forward * (2.0 / (f - n)), -(f + n) / (f - n));
        rows[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    }
    return glm::transpose(rows);
}

glm::dvec2 project(const Camera& camera, const glm::dvec3& point) {
    const glm::dvec3 seen = along_axes(camera, point - camera.eye);
    return glm::dvec2(seen) / (camera.perspective ? camera.half * seen.z : camera.half);
}

std::array<double, 4> map_rectangle(const View& view, const Snapshot& first) {
    const Block block = frame_block(first, 1.0);
    const auto width = static_cast<double>(view.image.width);
    const auto height = static_cast<double>(view.image.height);
    CameraSettings settings = view.camera;
    settings.projection = Projection::map;
    const Camera camera = place_camera(settings, block, width / height, 0.0);
    const glm::dvec2 low = project(camera, {-0.5 * block.width_x, -0.5 * block.width_y, 0.0});
    const glm::dvec2 high = project(camera, {0.5 * block.width_x, 0.5 * block.width_y, 0.0});
    return {0.5 * (1.0 + low.x) * width, 0.5 * (1.0 - high.y) * height,
            0.5 * (high.x - low.x) * width, 0.5 * (high.y - low.y) * height};
}

}  // namespace fumon
