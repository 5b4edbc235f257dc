#include "render/view/framing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fumon {

namespace {

/// The bed's height at a place in cells, between its four nearest centres.
double height_at(const Snapshot& snapshot, double x, double y) {
    const Grid& bed = snapshot.bed;
    const auto cell = [](double place, int count, bool periodic) {
        const int index = static_cast<int>(std::floor(place));
        return periodic ? ((index % count) + count) % count : std::clamp(index, 0, count - 1);
    };
    const double column = std::clamp(x, -1e8, 1e8) - 0.5;
    const double row = std::clamp(y, -1e8, 1e8) - 0.5;
    const auto height = [&](double i, double j) {
        return bed(cell(column + i, bed.nx(), snapshot.periodic),
                   cell(row + j, bed.ny(), snapshot.periodic));
    };
    const double east = column - std::floor(column);
    const double north = row - std::floor(row);
    return (1.0 - north) * ((1.0 - east) * height(0, 0) + east * height(1, 0)) +
           north * ((1.0 - east) * height(0, 1) + east * height(1, 1));
}

/// A place of the scene in the block's lengths; none for an empty one.
std::optional<glm::dvec3> place_in_block(const std::vector<double>& place, const Snapshot& first,
                                         const Block& block) {
    if (place.empty()) return std::nullopt;
    const double ground = height_at(first, place[0] / first.scale.dx, place[1] / first.scale.dy);
    return glm::dvec3(place[0] / block.side - 0.5 * block.width_x,
                      place[1] / block.side - 0.5 * block.width_y,
                      block.z(ground + place[2] / first.scale.height_unit));
}

}  // namespace

Block framed_block(const View& view, const Snapshot& first) {
    const WordOrReal& wanted = view.look.exaggeration;
    const double exaggeration = !wanted.is_word()         ? wanted.value
                                : wanted.word == "relief" ? relief_exaggeration(first)
                                                          : automatic_exaggeration(first);
    Block block = frame_block(first, exaggeration, view.look.room);
    block.eye = place_in_block(view.camera.at, first, block);
    block.look_at = place_in_block(view.camera.look_at, first, block);
    return block;
}

Camera camera_at_step(const View& view, const Block& block, std::int64_t step,
                      std::int64_t last_step) {
    const double progress =
        last_step > 0 ? static_cast<double>(step) / static_cast<double>(last_step) : 0.0;
    const double aspect =
        static_cast<double>(view.image.width) / static_cast<double>(view.image.height);
    return place_camera(view.camera, block, aspect, std::clamp(progress, 0.0, 1.0));
}

double pixels_per_length(const Camera& camera, const View& view) {
    const double depth = camera.perspective ? camera.focus : 1.0;
    return 0.5 * static_cast<double>(view.image.height) / (camera.half.y * std::max(depth, 0.05));
}

}  // namespace fumon
