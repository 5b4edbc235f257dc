#pragma once

#include <cstddef>
#include <cstdint>

#include "render/samples/triangle_vectors.h"

namespace fumon::seen_vectors {

/// A linear function of an offset from the eye.
struct Row {
    double x;
    double y;
    double z;
};

/// Where offsets from the eye stand in the picture, in perspective: x and y over depth, and
/// nearness = near_depth / depth.
struct Perspective {
    Row x;
    Row y;
    Row depth;
    double near_depth;
};

/// Sets corners first … first + count − 1 from offsets (x, y, z by turns). Those nearer than
/// near_depth, or farther aside than that, get no place: nearness 0.
void place_corners(const Perspective& projection, const float* offsets, std::size_t count,
                   triangle_vectors::Corners& corners, std::size_t first);

/// The level part of the ray through the middle of a row's sample in the picture's first column,
/// and how it changes to the next sample rightward and upward.
struct LevelRays {
    float first_x;
    float first_y;
    float right_x;
    float right_y;
    float up_x;
    float up_y;
};

/// Of `count` samples of a row from that column on, as a Band has them: their numbers, and the
/// length on the ground, along the view, from each to the next ones rightward and upward, the sum
/// of both. A number and a float by turns, `count` of each.
void lengths_of_row(const std::uint32_t* samples, const std::uint32_t* slopes,
                    const LevelRays& rays, float first_column, std::size_t count,
                    std::uint32_t* out);

}  // namespace fumon::seen_vectors
