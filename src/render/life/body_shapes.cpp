#include "render/life/body_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/elementary.h"

namespace fumon {

namespace {

/// A row of points around a limb, and the share of its colour.
struct BodyRow {
    std::vector<glm::dvec3> points;
    double shade = 1.0;
};

/// Through b and c, at t = 0 … 1 (Catmull & Rom 1974).
double between_points(double a, double b, double c, double d, double t) {
    return b +
           0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

BodyRing ring_between(const std::vector<BodyRing>& rings, std::size_t i, double t) {
    const BodyRing& b = rings[i];
    const BodyRing& c = rings[i + 1];
    const BodyRing& a = i > 0 ? rings[i - 1] : b;
    const BodyRing& d = i + 2 < rings.size() ? rings[i + 2] : c;
    BodyRing ring{};
    for (int axis = 0; axis < 3; ++axis)
        ring.middle[axis] =
            between_points(a.middle[axis], b.middle[axis], c.middle[axis], d.middle[axis], t);
    ring.width = std::max(between_points(a.width, b.width, c.width, d.width, t), 0.0);
    ring.depth = std::max(between_points(a.depth, b.depth, c.depth, d.depth, t), 0.0);
    ring.folds = b.folds + t * (c.folds - b.folds);
    ring.shade = b.shade + t * (c.shade - b.shade);
    return ring;
}

/// A surface of rows that are closed around; normals from its own differences.
void add_surface(BodyMesh& mesh, const std::vector<BodyRow>& rows, const glm::vec3& colour,
                 bool is_detail) {
    const auto sides = static_cast<int>(rows.front().points.size());
    const auto first = static_cast<std::uint32_t>(mesh.corners.size());
    const auto point = [&](std::size_t row, int side) {
        return rows[row].points[static_cast<std::size_t>((side + sides) % sides)];
    };
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::size_t below = row > 0 ? row - 1 : row;
        const std::size_t above = std::min(row + 1, rows.size() - 1);
        for (int side = 0; side < sides; ++side) {
            glm::dvec3 around = point(row, side + 1) - point(row, side - 1);
            if (glm::length(around) < 1e-9) {  // a pole
                const std::size_t next = row == 0 ? 1 : row - 1;
                around = point(next, side + 1) - point(next, side - 1);
            }
            const glm::dvec3 along = point(above, side) - point(below, side);
            mesh.corners.push_back({glm::vec3(point(row, side)),
                                    glm::vec3(glm::normalize(glm::cross(around, along))),
                                    static_cast<float>(rows[row].shade) * colour});
        }
    }
    const auto corner = [&](std::size_t row, int side) {
        return first + static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(sides) +
               static_cast<std::uint32_t>(side % sides);
    };
    std::vector<std::uint32_t>& indices = is_detail ? mesh.details : mesh.indices;
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        for (int side = 0; side < sides; ++side) {
            const std::uint32_t b = corner(row, side + 1);
            const std::uint32_t c = corner(row + 1, side);
            indices.insert(indices.end(),
                           {corner(row, side), b, c, b, corner(row + 1, side + 1), c});
        }
    }
}

BodyRow row_of(const BodyRing& ring, const LimbLook& look) {
    BodyRow row{{}, ring.shade};
    row.points.reserve(static_cast<std::size_t>(look.sides));
    for (int side = 0; side < look.sides; ++side) {
        const double angle = 2.0 * std::numbers::pi * side / look.sides;
        const double c = elementary::cos(angle);
        const double s = elementary::sin(angle);
        const double out = 1.0 + look.box * 4.0 * c * c * s * s;
        double fold = 0.0;
        if (ring.folds > 0.0) {
            const double z = ring.middle.z;
            const double here = 0.5 + 0.5 * elementary::sin(angle + 17.0 * z + 3.0 * look.phase);
            fold = ring.folds *
                   (here * elementary::sin(2.0 * angle + 83.0 * z + look.phase) +
                    (1.0 - here) * elementary::sin(3.0 * angle - 58.0 * z - 2.0 * look.phase));
        }
        row.points.push_back(ring.middle + glm::dvec3((ring.width * out + fold) * c,
                                                      (ring.depth * out + fold) * s, 0.0));
    }
    return row;
}

std::vector<BodyRow> ball_rows(const glm::dvec3& middle, const glm::dvec3& radii, int sides) {
    const int steps = std::max(sides / 2, 4);
    std::vector<BodyRow> rows;
    rows.reserve(static_cast<std::size_t>(steps) + 1);
    for (int step = 0; step <= steps; ++step) {
        const double rise = std::numbers::pi * (static_cast<double>(step) / steps - 0.5);
        BodyRow& row = rows.emplace_back();
        row.points.reserve(static_cast<std::size_t>(sides));
        const double out = step == 0 || step == steps ? 0.0 : elementary::cos(rise);
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            row.points.push_back(middle + radii * glm::dvec3(out * elementary::cos(angle),
                                                             out * elementary::sin(angle),
                                                             elementary::sin(rise)));
        }
    }
    return rows;
}

}  // namespace

void add_limb(BodyMesh& mesh, const std::vector<BodyRing>& rings, const LimbLook& look) {
    std::vector<BodyRow> rows;
    const auto add_end = [&](const BodyRing& end, bool is_lower, double bulge) {
        constexpr std::array round_shares{0.05, 0.45, 0.8, 0.95};
        constexpr std::array flat_shares{0.05, 0.97};
        const std::span<const double> shares =
            bulge > 0.1 ? std::span<const double>(round_shares) : flat_shares;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            const double share = is_lower ? shares[k] : shares[shares.size() - 1 - k];
            BodyRing round = end;
            round.width *= share;
            round.depth *= share;
            round.folds *= share;
            round.middle.z += (is_lower ? -bulge : bulge) * std::sqrt(1.0 - share * share) *
                              std::min(end.width, end.depth);
            rows.push_back(row_of(round, look));
        }
    };
    rows.reserve(8 + static_cast<std::size_t>(look.between) * rings.size());
    add_end(rings.front(), true, look.below);
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        for (int k = 0; k < look.between; ++k)
            rows.push_back(
                row_of(ring_between(rings, i, static_cast<double>(k) / look.between), look));
    }
    rows.push_back(row_of(rings.back(), look));
    add_end(rings.back(), false, look.above);
    add_surface(mesh, rows, look.colour, look.is_detail);
}

void add_round(BodyMesh& mesh, const glm::dvec3& middle, const glm::dvec3& radii,
               const glm::vec3& colour, int sides) {
    add_surface(mesh, ball_rows(middle, radii, sides), colour, false);
}

void add_detail(BodyMesh& mesh, const glm::dvec3& middle, const glm::dvec3& radii,
                const glm::vec3& colour) {
    add_surface(mesh, ball_rows(middle, radii, 10), colour, true);
}

void move_from(BodyMesh& mesh, std::size_t first,
               const std::function<glm::dvec3(const glm::dvec3&)>& moved) {
    for (std::size_t i = first; i < mesh.corners.size(); ++i)
        mesh.corners[i].position = glm::vec3(moved(glm::dvec3(mesh.corners[i].position)));
}

void turn_from(BodyMesh& mesh, std::size_t first, double angle) {
    const auto c = static_cast<float>(elementary::cos(angle));
    const auto s = static_cast<float>(elementary::sin(angle));
    const auto turned = [&](const glm::vec3& v) {
        return glm::vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    for (std::size_t i = first; i < mesh.corners.size(); ++i) {
        mesh.corners[i].position = turned(mesh.corners[i].position);
        mesh.corners[i].normal = turned(mesh.corners[i].normal);
    }
}

}  // namespace fumon
