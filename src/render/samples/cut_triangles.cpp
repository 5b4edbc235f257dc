#include "render/samples/cut_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

/// How far inside one of the planes that bound places that are numbers: 0 or more inside.
double inside(int plane, const DeepPlace& place, double near_depth) {
    switch (plane) {
        case 0:
            return place.z - near_depth;
        case 1:
            return farthest_place * place.z - place.x;
        case 2:
            return farthest_place * place.z + place.x;
        case 3:
            return farthest_place * place.z - place.y;
        default:
            return farthest_place * place.z + place.y;
    }
}

constexpr int planes = 5;

/// Whether one of them tells all of a triangle from the inside.
bool lies_outside(const std::array<DeepPlace, 3>& corners, double near_depth) {
    for (int plane = 0; plane < planes; ++plane) {
        const auto is_out = [&](const DeepPlace& place) {
            return inside(plane, place, near_depth) < 0.0;
        };
        if (std::ranges::all_of(corners, is_out)) return true;
    }
    return false;
}

/// What is left of a polygon on the inner side of a plane (Sutherland & Hodgman 1974). An edge is
/// cut from its inner end, in both triangles that share it.
std::vector<DeepPlace> cut_by(int plane, const std::vector<DeepPlace>& polygon, double near_depth) {
    std::vector<DeepPlace> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DeepPlace& from = polygon[i];
        const DeepPlace& to = polygon[(i + 1) % polygon.size()];
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

void add_cut(const std::array<DeepPlace, 3>& triangle, double near_depth,
             triangle_vectors::Corners& corners, std::vector<std::uint32_t>& triangles) {
    if (lies_outside(triangle, near_depth)) return;
    std::vector<DeepPlace> polygon(triangle.begin(), triangle.end());
    for (int plane = 0; plane < planes; ++plane) polygon = cut_by(plane, polygon, near_depth);
    const auto first = static_cast<std::uint32_t>(corners.x.size());
    for (const DeepPlace& place : polygon) {
        corners.x.push_back(static_cast<std::int32_t>(std::floor(place.x / place.z + 0.5)));
        corners.y.push_back(static_cast<std::int32_t>(std::floor(place.y / place.z + 0.5)));
        corners.nearness.push_back(static_cast<float>(near_depth / place.z));
    }
    for (std::uint32_t k = 2; k < polygon.size(); ++k)
        triangles.insert(triangles.end(), {first, first + k - 1, first + k});
}

}  // namespace fumon
