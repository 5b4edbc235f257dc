#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/samples/rasteriser_vectors.h"

namespace fumon {

/// x and y of a place in the picture times its depth, and the depth.
using ClipPosition = glm::dvec3;

/// How far from the picture's lower left corners have a place, in 1/256 of a sample: what differs
/// by less than twice as much is a number of 32 bits, and any picture is smaller.
inline constexpr double guard_band = 16777216.0;

/// Adds what is left of a triangle that reaches nearer than `near_depth` or farther aside: corners,
/// and triangles of them that turn the same way. Reversed z is near_depth / depth.
void add_clipped(const std::array<ClipPosition, 3>& triangle, double near_depth,
                 rasteriser_vectors::ProjectedVertices& vertices,
                 std::vector<std::uint32_t>& triangles);

}  // namespace fumon
