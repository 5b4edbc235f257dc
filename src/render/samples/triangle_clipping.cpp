#include "render/samples/triangle_clipping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

/// How far inside one of the planes that bound places that are numbers: 0 or more inside.
double inside(int plane, const ClipPosition& position, double near_depth) {
    switch (plane) {
        case 0:
            return position.z - near_depth;
        case 1:
            return guard_band * position.z - position.x;
        case 2:
            return guard_band * position.z + position.x;
        case 3:
            return guard_band * position.z - position.y;
        default:
            return guard_band * position.z + position.y;
    }
}

constexpr int planes = 5;

/// Whether one of them tells all of a triangle from the inside.
bool lies_outside(const std::array<ClipPosition, 3>& vertices, double near_depth) {
    for (int plane = 0; plane < planes; ++plane) {
        const auto is_out = [&](const ClipPosition& position) {
            return inside(plane, position, near_depth) < 0.0;
        };
        if (std::ranges::all_of(vertices, is_out)) return true;
    }
    return false;
}

/// What is left of a polygon on the inner side of a plane (Sutherland & Hodgman 1974). An edge is
/// cut from its inner end, in both triangles that share it.
std::vector<ClipPosition> clip_polygon(int plane, const std::vector<ClipPosition>& polygon,
                                       double near_depth) {
    std::vector<ClipPosition> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipPosition& from = polygon[i];
        const ClipPosition& to = polygon[(i + 1) % polygon.size()];
        const double in_from = inside(plane, from, near_depth);
        const double in_to = inside(plane, to, near_depth);
        if (in_from >= 0.0) left.push_back(from);
        if (in_from >= 0.0 && in_to < 0.0)
            left.push_back(from + (to - from) * (in_from / (in_from - in_to)));
        if (in_from < 0.0 && in_to >= 0.0)
            left.push_back(to + (from - to) * (in_to / (in_to - in_from)));
    }
    return left;
}

}  // namespace

void add_clipped(const std::array<ClipPosition, 3>& triangle, double near_depth,
                 rasteriser_vectors::ProjectedVertices& vertices,
                 std::vector<std::uint32_t>& triangles) {
    if (lies_outside(triangle, near_depth)) return;
    std::vector<ClipPosition> polygon(triangle.begin(), triangle.end());
    for (int plane = 0; plane < planes; ++plane) polygon = clip_polygon(plane, polygon, near_depth);
    const auto first = static_cast<std::uint32_t>(vertices.x.size());
    for (const ClipPosition& position : polygon) {
        vertices.x.push_back(static_cast<std::int32_t>(std::floor(position.x / position.z + 0.5)));
        vertices.y.push_back(static_cast<std::int32_t>(std::floor(position.y / position.z + 0.5)));
        vertices.reversed_z.push_back(static_cast<float>(near_depth / position.z));
    }
    for (std::uint32_t k = 2; k < polygon.size(); ++k)
        triangles.insert(triangles.end(), {first, first + k - 1, first + k});
}

}  // namespace fumon
