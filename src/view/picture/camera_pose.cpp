#include "view/picture/camera_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/elementary_power.h"
#include "base/units.h"
#include "render/view/block.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"
#include "render/view/tile_warp.h"

namespace fumon {

namespace {

struct PlacedCamera {
    Camera camera;
    Block block;  ///< of the frame
};

PlacedCamera place(const Scene& scene, const Snapshot& whole_first, const Snapshot& whole) {
    View view = with_chosen_ground(scene.view, whole_first);
    const std::optional<Snapshot> shown_first = shown_snapshot(whole_first, view);
    const std::optional<Snapshot> shown = shown_snapshot(whole, view);
    const Snapshot& first = shown_first ? *shown_first : whole_first;
    const Snapshot& drawn = shown ? *shown : whole;
    view = standing_on(view, first, drawn);
    const Block block = framed_block(view, first);
    const Block framed = block_of_frame(block, view.look, first, drawn);
    return {above_ground(camera_at_step(view, block, drawn.step, scene.run.steps), framed, drawn,
                         tile_warp_of(view, block, first)),
            block};
}

std::array<double, 3> outside(const Block& block, const glm::dvec3& point) {
    return {(point.x + 0.5 * block.width_x) * block.side,
            (point.y + 0.5 * block.width_y) * block.side, point.z * block.side};
}

/// To a ten-thousandth of a block.
double rounded(double value, double side) {
    const double unit = elementary::pow(10.0, std::floor(elementary::log10(side)) - 4.0);
    return std::round(value / unit) * unit;
}

std::string list_of(const std::array<double, 3>& values, double side) {
    return fmt::format("[{:.7g}, {:.7g}, {:.7g}]", rounded(values[0], side),
                       rounded(values[1], side), rounded(values[2], side));
}

}  // namespace

Camera camera_of_still(const Scene& scene, const Snapshot& first, const Snapshot& snapshot) {
    return place(scene, first, snapshot).camera;
}

CameraFacts camera_facts(const Scene& scene, const Snapshot& first, const Snapshot& snapshot) {
    const auto [camera, block] = place(scene, first, snapshot);
    CameraFacts facts;
    double ahead = camera.focus;
    if (!(ahead > 0.0) || !std::isfinite(ahead)) ahead = 1.0;
    if (block.eye && !block.look_at) ahead = 0.5;
    facts.place.eye = outside(block, camera.eye);
    facts.place.target = outside(block, camera.eye + ahead * camera.forward);
    facts.azimuth = elementary::atan2(-camera.forward.x, -camera.forward.y) / degree;
    facts.elevation = elementary::atan2(-camera.forward.z,
                                        elementary::hypot(camera.forward.x, camera.forward.y)) /
                      degree;
    const glm::dvec3 centre(0.0, 0.0, 0.5 * (block.base + block.top));
    const double half_angle = 0.5 * scene.view.camera.field_of_view * degree;
    facts.distance = camera.perspective ? glm::length(camera.eye - centre)
                                        : camera.half.y * elementary::cos(half_angle) /
                                              elementary::sin(half_angle);
    facts.side = block.side;
    facts.tangent = camera.half.y;
    return facts;
}

std::vector<std::string> settings_of(const CameraPlace& wanted, const Scene& scene,
                                     const Snapshot& first, const Snapshot& snapshot) {
    Scene standing = scene;
    CameraSettings& camera = standing.view.camera;
    camera.framing = Framing::block;
    const auto settle = [&](std::array<double, 3> place_there, bool is_eye) {
        camera.at = {place_there[0], place_there[1], 0.0};
        camera.look_at = {wanted.target[0], wanted.target[1], 0.0};
        if (!is_eye) camera.look_at = camera.at;
        const PlacedCamera ground = place(standing, first, snapshot);
        const double z = place_there[2] / ground.block.side;
        place_there[2] =
            (z - ground.camera.eye.z) / ground.block.height_scale * first.scale.height_unit;
        return place_there;
    };
    // At most as low as the ground: a camera in it is lifted.
    const std::array<double, 3> target = settle(wanted.target, false);
    std::array<double, 3> eye = settle(wanted.eye, true);
    const double side = place(standing, first, snapshot).block.side;
    constexpr double least = 0.002;  // block lengths
    eye[2] = std::max(eye[2], least * side);
    return {"camera.framing=\"block\"", "camera.at=" + list_of(eye, side),
            "camera.look_at=" + list_of(target, side)};
}

}  // namespace fumon
