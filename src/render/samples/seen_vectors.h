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

/// Samples of a row, as a Band has them.
struct SeenRow {
    const std::uint32_t* samples;
    const std::uint32_t* slopes;
    LevelRays rays;
};

/// Of `count` samples of a row and of the next one, from that column on: their numbers; and, as
/// floats, the length on the ground, along the view, from each to the next ones rightward and
/// upward, the sum of both. By fours, two of the lower row and two of the upper. `count` is a
/// multiple of 16.
void note_rows(const SeenRow& lower, const SeenRow& upper, float first_column, std::size_t count,
               std::uint32_t* numbers, std::uint32_t* lengths);

}  // namespace fumon::seen_vectors
