#pragma once

#include <cstddef>
#include <cstdint>

#include "render/samples/rasteriser_vectors.h"

namespace fumon::visibility_vectors {

/// A linear function of an offset from the eye.
struct LinearForm {
    double x;
    double y;
    double z;
};

/// Where offsets from the eye stand in the picture, in perspective: x and y over depth, and
/// reversed_z = near_depth / depth.
struct Perspective {
    LinearForm x;
    LinearForm y;
    LinearForm depth;
    double near_depth;
};

/// Sets corners first … first + count − 1 from offsets (x, y, z by turns). Those nearer than
/// near_depth, or farther aside than that, get no place: reversed_z 0.
void project_vertices(const Perspective& projection, const float* offsets, std::size_t count,
                      rasteriser_vectors::ProjectedVertices& vertices, std::size_t first);

/// The level part of the ray through the middle of a row's sample in the picture's first column,
/// and how it changes to the next sample rightward and upward.
struct HorizontalRays {
    float first_x;
    float first_y;
    float right_x;
    float right_y;
    float up_x;
    float up_y;
};

/// Samples of a row, as a Band has them.
struct VisibilityRow {
    const std::uint32_t* samples;
    const std::uint32_t* slopes;
    HorizontalRays rays;
};

/// Of `count` samples of a row and of the next one, from that column on: their numbers; and, as
/// floats, the length on the ground, along the view, from each to the next ones rightward and
/// upward, the sum of both. By fours, two of the lower row and two of the upper. `count` is a
/// multiple of 16.
void record_rows(const VisibilityRow& lower, const VisibilityRow& upper, float first_column,
                 std::size_t count, std::uint32_t* numbers, std::uint32_t* lengths);

}  // namespace fumon::visibility_vectors
