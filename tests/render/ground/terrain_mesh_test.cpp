#include "render/ground/terrain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "render/ground/outline_rim.h"

namespace fumon {
namespace {

constexpr double largest_error = 0.5;  // pixels, of a vertex that is left out

/// Hills, a cliff and noise.
std::vector<float> rough_heights(const TerrainLattice& lattice) {
    std::vector<float> heights;
    std::uint32_t random = 1;
    for (const MeshPosition& position : lattice.positions) {
        random = random * 1664525U + 1013904223U;
        const double noise = static_cast<double>(random >> 16U) / 65536.0;
        const double cliff = position.east + 0.3 * position.north > 0.8 ? 9.0 : 0.0;
        const double rough = position.north > 0.7 ? noise : 0.0;
        heights.push_back(static_cast<float>(
            4.0 * std::sin(9.0 * position.east + 3.0 * position.north) + cliff + rough));
    }
    return heights;
}

TerrainMesh meshed(const TerrainLattice& lattice, const std::vector<float>& heights, int square,
                   const ScreenScale& scale = {}) {
    TerrainMesher mesher;
    return mesher.mesh(lattice, heights, scale, square, {});
}

double twice_area(const TerrainLattice& lattice, const TerrainMesh& mesh, std::size_t triangle) {
    const std::uint32_t* of = mesh.triangles.data() + 3 * triangle;
    const MeshPosition a = lattice.positions[of[0]];
    const MeshPosition b = lattice.positions[of[1]];
    const MeshPosition c = lattice.positions[of[2]];
    return (b.east - a.east) * (c.north - a.north) - (c.east - a.east) * (b.north - a.north);
}

double area(const TerrainLattice& lattice, const TerrainMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i) {
        EXPECT_GT(twice_area(lattice, mesh, i), -1e-7);  // all turn the same way
        sum += 0.5 * twice_area(lattice, mesh, i);
    }
    return sum;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How many triangles have each edge.
std::map<Edge, int> edges_of(const TerrainMesh& mesh) {
    std::map<Edge, int> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[i + k];
            const std::uint32_t b = mesh.triangles[i + (k + 1) % 3];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    }
    return edges;
}

TEST(TerrainMesh, CoversTheBedWithoutCracks) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 9}, {21, 14}, {64, 64}, {61, 67}}) {
        for (const int square : {1, 2, 4, 8, 32}) {
            const TerrainLattice lattice = terrain_lattice(nx, ny, Mask(), 1);
            const TerrainMesh mesh = meshed(lattice, rough_heights(lattice), square);
            EXPECT_NEAR(area(lattice, mesh), 1.0, 1e-5) << nx << " x " << ny << ", " << square;
            std::size_t open = 0;
            for (const auto& [edge, count] : edges_of(mesh)) {
                EXPECT_LE(count, 2);
                open += count == 1 ? 1U : 0U;
            }
            EXPECT_EQ(open, mesh.sides.size());  // all of them at the border, and faced
            for (const SideFace& side : mesh.sides) {
                const MeshPosition a = lattice.positions[side.from];
                const MeshPosition b = lattice.positions[side.to];
                const auto border = [](float position) {
                    return position == 0.0F || position == 1.0F;
                };
                EXPECT_TRUE((a.east == b.east && border(a.east)) ||
                            (a.north == b.north && border(a.north)));
            }
        }
    }
}

/// How far each vertex of the lattice lies from the mesh, in z.
std::vector<double> distances(const TerrainLattice& lattice, const std::vector<float>& heights,
                              const TerrainMesh& mesh) {
    std::vector<double> off(heights.size(), 1e9);
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i) {
        const std::array<std::uint32_t, 3> of{mesh.triangles[3 * i], mesh.triangles[3 * i + 1],
                                              mesh.triangles[3 * i + 2]};
        std::array<MeshPosition, 3> at{};
        std::array<double, 3> z{};
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = lattice.positions[of[k]];
            z[k] = heights[of[k]];
        }
        const double whole = twice_area(lattice, mesh, i);
        for (std::size_t v = 0; v < heights.size(); ++v) {
            const MeshPosition p = lattice.positions[v];
            std::array<double, 3> share{};
            for (std::size_t k = 0; k < 3; ++k) {
                const MeshPosition a = at[(k + 1) % 3];
                const MeshPosition b = at[(k + 2) % 3];
                share[k] = ((b.east - a.east) * (p.north - a.north) -
                            (p.east - a.east) * (b.north - a.north)) /
                           whole;
            }
            if (*std::min_element(share.begin(), share.end()) < -1e-4) continue;
            const double there = share[0] * z[0] + share[1] * z[1] + share[2] * z[2];
            off[v] = std::min(off[v], std::abs(heights[v] - there));
        }
    }
    return off;
}

TEST(TerrainMesh, KeepsToTheBedWithinAPixel) {
    const TerrainLattice lattice = terrain_lattice(45, 38, Mask(), 1);
    const std::vector<float> heights = rough_heights(lattice);
    for (const float pixels : {0.3F, 1.0F, 3.0F}) {
        ScreenScale scale;
        scale.pixels = pixels;
        const TerrainMesh mesh = meshed(lattice, heights, 16, scale);
        const std::vector<double> off = distances(lattice, heights, mesh);
        const double largest = pixels * *std::max_element(off.begin(), off.end());
        EXPECT_LE(largest, 2.0 * largest_error);  // of a few levels' errors together
        EXPECT_GT(largest, 0.1) << "vertices are left out";
    }
}

TEST(TerrainMesh, IsCoarserFarFromTheEye) {
    const TerrainLattice lattice = terrain_lattice(64, 64, Mask(), 1);
    std::vector<float> heights(lattice.positions.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (i % 66) % 2 == 0 ? 0.4F : 0.0F;  // each second column is a ridge
    ScreenScale scale;
    scale.depth = 0.5F;
    scale.depth_north = 1.0F;
    const TerrainMesh mesh = meshed(lattice, heights, 8, scale);
    std::size_t near = 0;
    std::size_t far = 0;
    for (const std::uint32_t vertex : mesh.triangles) {
        near += lattice.positions[vertex].north < 0.25F ? 1U : 0U;
        far += lattice.positions[vertex].north > 0.75F ? 1U : 0U;
    }
    EXPECT_GT(near, 3 * far);
}

TEST(TerrainMesh, AFlatBedTakesFewTriangles) {
    const TerrainLattice lattice = terrain_lattice(63, 63, Mask(), 1);  // 64 quads
    const std::vector<float> heights(lattice.positions.size(), 1.0F);
    EXPECT_EQ(meshed(lattice, heights, 1).triangles.size(), 64U * 64U * 6U);
    EXPECT_EQ(meshed(lattice, heights, 8).triangles.size(), 8U * 8U * 6U);
}

TEST(TerrainMesh, AMaskedRimHasOneFaceForEachOpenSide) {
    Mask nodata(9, 7);
    nodata(4, 3) = 1;  // a hole: its four corners take four quads away
    const TerrainLattice whole = terrain_lattice(9, 7, Mask(), 1);
    const TerrainLattice holed = terrain_lattice(9, 7, nodata, 1);
    for (const int square : {1, 4, 8}) {
        const std::vector<float> heights(whole.positions.size(), 0.0F);
        const TerrainMesh mesh = meshed(holed, heights, square);
        const double quad = area(whole, meshed(whole, heights, square)) - area(holed, mesh);
        EXPECT_NEAR(quad, 4.0 / (9.0 * 7.0), 1e-6);
        std::size_t open = 0;
        for (const auto& [edge, count] : edges_of(mesh)) open += count == 1 ? 1U : 0U;
        EXPECT_EQ(open, mesh.sides.size() + 8U);
    }
    EXPECT_EQ(rim_faces(holed, 1.0F).size(), 8U);
    EXPECT_TRUE(rim_faces(whole, 1.0F).empty());
}

TEST(TerrainMesh, TheLatticeIsAsFineAsTheScreen) {
    EXPECT_EQ(lattice_stride(8.0), 1);  // cells are wide already
    EXPECT_GE(lattice_stride(0.5), 4);  // cells are smaller than pixels
    EXPECT_EQ(largest_square(30.0), 1);
    EXPECT_GE(largest_square(2.5), 4);
    for (const int stride : {1, 2, 4}) {
        const TerrainLattice lattice = terrain_lattice(21, 14, Mask(), stride);
        EXPECT_EQ(lattice.positions.size(), lattice.cells.size());
        for (const std::uint32_t cell : lattice.cells) EXPECT_LT(cell, 21U * 14U);
    }
}

}  // namespace
}  // namespace fumon
