#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "base/truncation.h"
#include "render/view/block.h"
#include "render/view/camera.h"

namespace fumon {

/// The cell of a periodic bed that is the first one, the south-western, of the bed as it is drawn.
/// Endless ground is drawn from the camera's cell: means over 2, 4, 8 … cells, and what rounding
/// makes of points, then depend on where the ground lies from the camera, not on where the array
/// begins.
struct DrawnOrigin {
    int east = 0;  ///< cells from the array's first one
    int north = 0;
    glm::dvec2 share{0.0};     ///< the same, of the bed's sides
    glm::dvec2 position{0.0};  ///< the same, block lengths
};

/// Cameras stand at whole and half cells more often than anywhere else.
inline constexpr double cell_boundary_offset = 0.317;

/// The origin that centres the drawn bed on the camera's cell.
inline DrawnOrigin origin_around(const Camera& camera, const Block& block, int nx, int ny) {
    const auto first_of = [&](double position, double extent, int count) {
        const double share = position / extent + 0.5;
        const double within = (share - std::floor(share)) * count;
        const int cell = truncated_within(std::floor(within + cell_boundary_offset), 0, count);
        return ((cell - count / 2) % count + count) % count;
    };
    DrawnOrigin origin;
    origin.east = first_of(camera.eye.x, block.width_x, nx);
    origin.north = first_of(camera.eye.y, block.width_y, ny);
    origin.share = {static_cast<double>(origin.east) / nx, static_cast<double>(origin.north) / ny};
    origin.position = origin.share * glm::dvec2(block.width_x, block.width_y);
    return origin;
}

}  // namespace fumon
