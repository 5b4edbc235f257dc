#include "render/view/visible_part.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fumon {

namespace {

constexpr int cells = 64;        // along both sides
constexpr double border = 1.02;  // of half the picture: rounding, and what filters take from beyond
constexpr double above_top = 0.1;  // block lengths: water, and landforms that have grown
constexpr double nearest = 0.02;   // block lengths

/// Whether all corners of a box lie beyond one side of the picture, in clip coordinates.
bool outside_frustum(const std::array<glm::dvec4, 8>& corners) {
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const bool all = std::all_of(
                corners.begin(), corners.end(),
                [&](const glm::dvec4& corner) { return sign * corner[axis] > border * corner.w; });
            if (all) return true;
        }
    }
    return false;
}

}  // namespace

VisiblePart visible_part(const Camera& camera, const View& view, const Block& block) {
    const glm::dmat4 clip = clip_matrix(camera);
    const double low_z = block.base;
    const double high_z = std::max(block.top, block.surface) + above_top;
    VisiblePart part{glm::dvec2(1.0), glm::dvec2(0.0), 0.0};
    std::vector<double> distances;
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const glm::dvec2 low = glm::dvec2(x, y) / static_cast<double>(cells);
            const glm::dvec2 high = glm::dvec2(x + 1, y + 1) / static_cast<double>(cells);
            const auto world = [&](double east, double north, double z) {
                return glm::dvec3((east - 0.5) * block.width_x, (north - 0.5) * block.width_y, z);
            };
            std::array<glm::dvec4, 8> corners;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                corners[i] = clip * glm::dvec4(world((i & 1U) != 0 ? high.x : low.x,
                                                     (i & 2U) != 0 ? high.y : low.y,
                                                     (i & 4U) != 0 ? high_z : low_z),
                                               1.0);
            }
            if (outside_frustum(corners)) continue;
            part.low = glm::min(part.low, low);
            part.high = glm::max(part.high, high);
            const glm::dvec2 middle = 0.5 * (low + high);
            distances.push_back(
                glm::distance(camera.eye, world(middle.x, middle.y, block.surface)));
        }
    }
    if (distances.empty()) return part;
    double depth = 1.0;
    if (camera.perspective) {
        const auto quarter = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 4);
        std::nth_element(distances.begin(), quarter, distances.end());
        depth = std::max(*quarter, nearest);
    }
    part.sharpness = 0.5 * static_cast<double>(view.image.height) / (camera.half.y * depth);
    if (view.camera.has_lens()) {
        part.low = glm::dvec2(0.0);
        part.high = glm::dvec2(1.0);
    }
    return part;
}

}  // namespace fumon
