#include "render/ground/outline_rim.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fumon {

namespace {

constexpr double reach_of_steps = 1.6;  // of the lattice, within which a vertex goes to the outline
constexpr int smoothing_passes = 4;     // even: a vertex keeps a part of its own direction
constexpr float same_wall = 0.7F;       // cosine between a face and the wall that it is part of

/// A side of a quad: the step to the neighbour beyond it and its two ends, counter-clockwise.
struct QuadSide {
    int step_x;
    int step_y;
    std::array<int, 2> from;
    std::array<int, 2> to;
};

constexpr std::array<QuadSide, 4> quad_sides = {{{0, -1, {0, 0}, {1, 0}},
                                                 {1, 0, {1, 0}, {1, 1}},
                                                 {0, 1, {1, 1}, {0, 1}},
                                                 {-1, 0, {0, 1}, {0, 0}}}};

/// The quads around a vertex that are drawn, of the four that there may be.
int quads_drawn(const Mask& drawn, int x, int y) {
    int count = 0;
    for (const auto& [i, j] : {std::pair{x - 1, y - 1}, {x, y - 1}, {x - 1, y}, {x, y}})
        if (i >= 0 && j >= 0 && i < drawn.nx() && j < drawn.ny()) count += drawn(i, j) != 0 ? 1 : 0;
    return count;
}

int quads_around(const TerrainLattice& lattice, int x, int y) {
    const bool at_side = x == 0 || x == lattice.nx - 1;
    const bool at_end = y == 0 || y == lattice.ny - 1;
    return (at_side ? 1 : 2) * (at_end ? 1 : 2);
}

/// A direction, not yet of length 1.
struct Direction {
    float east = 0.0F;
    float north = 0.0F;

    void add(const Direction& other) {
        east += other.east;
        north += other.north;
    }
    [[nodiscard]] MeshPosition unit(MeshPosition instead) const {
        const float length = std::sqrt(east * east + north * north);
        return length > 0.0F ? MeshPosition{east / length, north / length} : instead;
    }
};

struct RimFace {
    std::uint32_t from;
    std::uint32_t to;
    MeshPosition flat;  ///< where the rim is not moved
    Direction outward;  ///< as long as the face
};

std::vector<RimFace> faces_of(const TerrainLattice& lattice, float aspect) {
    std::vector<RimFace> faces;
    const Mask& drawn = lattice.drawn;
    for (int j = 0; j < drawn.ny(); ++j) {
        for (int i = 0; i < drawn.nx(); ++i) {
            if (drawn(i, j) == 0) continue;
            for (const QuadSide& side : quad_sides) {
                const int x = i + side.step_x;
                const int y = j + side.step_y;
                if (x < 0 || y < 0 || x >= drawn.nx() || y >= drawn.ny()) continue;
                if (drawn(x, y) != 0) continue;
                const auto vertex = [&](const std::array<int, 2>& end) {
                    return static_cast<std::uint32_t>(j + end[1]) *
                               static_cast<std::uint32_t>(lattice.nx) +
                           static_cast<std::uint32_t>(i + end[0]);
                };
                const std::uint32_t from = vertex(side.from);
                const std::uint32_t to = vertex(side.to);
                const MeshPosition& one = lattice.positions[from];
                const MeshPosition& other = lattice.positions[to];
                faces.push_back({from,
                                 to,
                                 {static_cast<float>(side.step_x), static_cast<float>(side.step_y)},
                                 {other.north - one.north, aspect * (one.east - other.east)}});
            }
        }
    }
    return faces;
}

}  // namespace

std::vector<std::uint32_t> move_rim(TerrainLattice& lattice, const DisplayBed& bed) {
    std::vector<std::uint32_t> moved;
    if (lattice.drawn.empty()) return moved;
    const int nx = bed.z.nx() / bed.refinement;
    const int ny = bed.z.ny() / bed.refinement;
    const OutlineSearch search(bed.outline, nx, ny);
    const auto shares = [&](int y, int x) -> MeshPosition& {
        return lattice
            .positions[static_cast<std::size_t>(y) * static_cast<std::size_t>(lattice.nx) +
                       static_cast<std::size_t>(x)];
    };
    const int middle = std::min(1, lattice.nx - 2);
    const double step =
        nx * static_cast<double>(shares(0, middle + 1).east - shares(0, middle).east);
    for (int y = 0; y < lattice.ny; ++y) {
        for (int x = 0; x < lattice.nx; ++x) {
            const int count = quads_drawn(lattice.drawn, x, y);
            if (count == 0 || count == quads_around(lattice, x, y)) continue;
            MeshPosition& at = shares(y, x);
            const OutlinePoint home{at.east * static_cast<double>(nx),
                                    at.north * static_cast<double>(ny)};
            OutlinePoint to = search.nearest(home, reach_of_steps * step);
            // What stands on the bed's border stays on it.
            if (x == 0 || x == lattice.nx - 1) to.x = home.x;
            if (y == 0 || y == lattice.ny - 1) to.y = home.y;
            at = {static_cast<float>(to.x / nx), static_cast<float>(to.y / ny)};
            moved.push_back(static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(lattice.nx) +
                            static_cast<std::uint32_t>(x));
        }
    }
    return moved;
}

std::vector<SideFace> rim_faces(const TerrainLattice& lattice, float aspect) {
    const std::vector<RimFace> faces = faces_of(lattice, aspect);
    std::vector<Direction> at_vertices(lattice.positions.size());
    for (const RimFace& face : faces) {
        at_vertices[face.from].add(face.outward);
        at_vertices[face.to].add(face.outward);
    }
    for (int pass = 0; pass < smoothing_passes; ++pass) {
        std::vector<Direction> wider(at_vertices.size());
        for (const RimFace& face : faces) {
            wider[face.from].add(at_vertices[face.to]);
            wider[face.to].add(at_vertices[face.from]);
        }
        at_vertices.swap(wider);
    }
    std::vector<SideFace> sides;
    sides.reserve(faces.size());
    for (const RimFace& face : faces) {
        const MeshPosition flat = face.outward.unit(face.flat);
        const auto direction = [&](std::uint32_t vertex) {
            const MeshPosition wall = at_vertices[vertex].unit(flat);
            const bool same = wall.east * flat.east + wall.north * flat.north > same_wall;
            return same ? wall : flat;
        };
        sides.push_back({face.from, face.to, direction(face.from), direction(face.to)});
    }
    return sides;
}

}  // namespace fumon
