#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/ground/height_pyramid.h"

namespace fumon {

class WorkerPool;

/// Rays and rings around an eye over a periodic bed; block lengths.
struct GroundFan {
    glm::dvec2 heading{0.0, 1.0};  ///< of its middle, unit vector
    double half_angle = 0.0;       ///< radians
    double nearest = 0.0;          ///< radius of the innermost ring
    double farthest = 0.0;
    int rays = 2;
    glm::dvec3 eye{0.0};     ///< x and y from the bed's middle
    glm::dvec2 extent{1.0};  ///< of the bed
    /// How much its far copies are made unlike each other, and where the eye is: see TileWarp.
    double strength = 0.0;
    glm::dvec2 eye_from_middle{0.0};
    double mean = 0.0;
    double cell = 1.0;        ///< of the bed
    double curvature = 0.0;   ///< by which the planet sinks at a distance of 1
    double wall_slope = 0.0;  ///< by which or more walls rise; 0 where the bed has none
    double near_limit = 0.0;  ///< the distance that divides near ground from far
    double lens = 0.0;  ///< radius of a lens around the eye, all of whose points see the ground
};

/// The ground as triangles.
struct GroundMesh {
    std::vector<glm::vec3> positions;      ///< offsets from the eye
    std::vector<std::uint32_t> triangles;  ///< their corners, near ones first
    std::size_t near_indices = 0;          ///< how many of these are of near ones
    /// The direction, of length 1 on the level, in which the highest place of each ray is seen.
    std::vector<glm::vec3> skyline;
};

/// The ground that a camera sees.
struct VisibleGround {
    GroundMesh mesh;
    double sample_angle = 0.0;  ///< between two samples in the middle of the picture
    double near_limit = 0.0;    ///< a ripple is not seen beyond, block lengths
};

/// Where a ring crosses a ray the ground stands at the place between the neighbouring rings that
/// looks highest from the eye, so that crests are where they are however far apart the rings. What
/// nearer ground hides, from all points of the lens, is left out. Independent of the pool's size.
GroundMesh ground_mesh(const GroundFan& fan, const HeightPyramid& bed, WorkerPool& pool);

}  // namespace fumon
