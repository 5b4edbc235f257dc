#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace fumon {

/// A corner of a body's surface, metres.
struct BodyCorner {
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    glm::vec3 colour{0.5F};  ///< reflectances
};

/// Triangles: three indices of corners each.
struct BodyMesh {
    std::vector<BodyCorner> corners;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> details;  ///< likewise, of what changes no outline
};

/// A level ellipse of a limb: its middle and half its width (along x) and depth, metres.
struct BodyRing {
    glm::dvec3 middle{0.0};
    double width = 0.0;
    double depth = 0.0;
    double folds = 0.0;  ///< metres, of the cloth
    double shade = 1.0;  ///< of the colour, where little light gets in
};

/// What rings have in common.
struct LimbLook {
    glm::vec3 colour{0.5F};
    int sides = 20;      ///< corners around
    int between = 5;     ///< rings drawn from one given to the next
    double below = 1.0;  ///< how far the lower end is rounded off: 1 a half ball, 0 flat
    double above = 1.0;
    double box = 0.0;    ///< how far the diagonals stand out of the ellipse, a share
    double phase = 0.0;  ///< radians, of the folds
    bool is_detail = false;
};

/// Rings from below upward, joined smoothly (Catmull & Rom 1974).
void add_limb(BodyMesh& mesh, const std::vector<BodyRing>& rings, const LimbLook& look);

/// An ellipsoid.
void add_round(BodyMesh& mesh, const glm::dvec3& middle, const glm::dvec3& radii,
               const glm::vec3& colour, int sides);
/// A small one that is a detail.
void add_detail(BodyMesh& mesh, const glm::dvec3& middle, const glm::dvec3& radii,
                const glm::vec3& colour);

/// Moves the corners from `first` on; their normals stay.
void move_from(BodyMesh& mesh, std::size_t first,
               const std::function<glm::dvec3(const glm::dvec3&)>& moved);

/// Turns the corners from `first` on about the vertical through x = y = 0, radians anticlockwise.
void turn_from(BodyMesh& mesh, std::size_t first, double angle);

}  // namespace fumon
