// Endless ground as a mesh in polar coordinates around the eye: rays × 1000 rings.
//
// 1. From ring to ring radii grow by a factor, a smaller one at first: quads are of much the same
//    size on the screen from the eye's feet to the horizon.
// 2. A ring may be wider than a dune. A vertex therefore does not stand on its ring but where the
//    ground between the ring's edges looks highest from the eye (up to 12 samples): crests, which
//    are the picture's outlines, do not depend on where rings happen to lie.
// 3. Samples read means of the height pyramid, of cells up to a fifth of the distance between rays.
// 4. Hidden ground is left out twice, by a floating horizon (Wright 1973): the steepest tangent so
//    far along a ray. A ring that could not rise over it, were it as high as the bed's highest
//    ground, takes one sample instead of 12. A quad below the horizon of its two rays, of which the
//    lower one counts, is not drawn. From a lens all of whose points see the ground, what stands at
//    a distance r is seen lower by lens / r and aside by as much, so that rays beside count too.
// 5. The warp of far tiles is evaluated at the edges of rings and is linear between them.
// 6. Samples of up to 32 rings of one level are evaluated together, by vectors (ground_vectors.h):
//    rings wait for each other's horizon, but their heights do not.
// 7. At walls of rock wall_vertices.h chooses the vertices, so that foot and rim are among them.
//
//              ring k  k + 1
//    ray j + 1 ─── b0 ── b1 ──►      vertex = ray · 1000 + ring
//                  │  ╲  │           triangles a0 b0 a1 and b0 b1 a1;
//    ray j     ─── a0 ── a1 ──►      first all of near quads, then all of far ones
//    from the eye

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
    /// The direction, of length 1 on the level, in which the highest point of each ray is seen.
    std::vector<glm::vec3> skyline;
};

/// The ground that a camera sees.
struct VisibleGround {
    GroundMesh mesh;
    double sample_angle = 0.0;  ///< between two samples in the middle of the picture
    double near_limit = 0.0;    ///< a ripple is not seen beyond, block lengths
};

/// Where a ring crosses a ray the ground stands at the point between the neighbouring rings that
/// looks highest from the eye, so that crests are where they are however far apart the rings. What
/// nearer ground hides, from all points of the lens, is left out. Independent of the pool's size.
GroundMesh ground_mesh(const GroundFan& fan, const HeightPyramid& bed, WorkerPool& pool);

}  // namespace fumon
