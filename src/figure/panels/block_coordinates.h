#pragma once

#include <span>
#include <vector>

#include "figure/panels/ground_axes.h"
#include "figure/plot/coordinate_marks.h"

namespace fumon {

/// The corners of the hull of some points, counter-clockwise.
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points);

/// The coordinates along the lower edges of a block before which the camera stands.
struct BlockCoordinates {
    std::vector<CoordinateAxis> axes;             ///< of east and of north
    std::vector<std::vector<CanvasPoint>> lines;  ///< the edges, as they are seen
};

/// Those of a block whose bed lies as `scale` says and is `length_x` × `length_y` metres or sites
/// large. Where cells without data lie around the others, the edges are those of the hull of the
/// others; each shows the coordinates that change along it.
BlockCoordinates block_coordinates(const ViewProjection& view, const WorldScale& scale,
                                   double length_x, double length_y);

inline constexpr Ink coordinate_ink{0.1, 0.1, 0.1, 0.85};

/// Draws ticks and their texts; `plate` is the opacity of a white one under each text.
void draw_coordinate_marks(Canvas& canvas, std::span<const CoordinateMark> marks, double plate);

}  // namespace fumon
