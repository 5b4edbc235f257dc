#include "render/ground/terrain_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fumon {

namespace {

constexpr double shortest_edge = 2.2;  // pixels: nothing is gained by finer triangles
constexpr double longest_edge = 24.0;  // pixels, of a square that becomes two triangles
constexpr float largest_error = 0.5F;  // pixels between mesh and bed
constexpr int largest_stride = 64;
constexpr float always = std::numeric_limits<float>::infinity();

/// The vertices along one axis: where they stand, 0 … 1, and which cell gives the height.
struct Axis {
    std::vector<float> positions;
    std::vector<int> cells;
};

Axis make_axis(int count, int stride) {
    Axis axis;
    axis.positions.push_back(0.0F);
    axis.cells.push_back(0);
    for (int cell = stride / 2; cell < count; cell += stride) {
        axis.positions.push_back((static_cast<float>(cell) + 0.5F) / static_cast<float>(count));
        axis.cells.push_back(cell);
    }
    axis.positions.push_back(1.0F);
    axis.cells.push_back(count - 1);
    return axis;
}

Mask drawn_quads(const Axis& east, const Axis& north, const Mask& nodata) {
    if (nodata.empty()) return {};
    Mask drawn(static_cast<int>(east.cells.size()) - 1, static_cast<int>(north.cells.size()) - 1);
    for (int j = 0; j < drawn.ny(); ++j) {
        for (int i = 0; i < drawn.nx(); ++i) {
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            const int outside = nodata(east.cells[a], north.cells[b]) +
                                nodata(east.cells[a + 1], north.cells[b]) +
                                nodata(east.cells[a], north.cells[b + 1]) +
                                nodata(east.cells[a + 1], north.cells[b + 1]);
            drawn(i, j) = outside == 0 ? 1 : 0;
        }
    }
    return drawn;
}

/// A vertex by its place in the lattice.
struct Vertex {
    int x;
    int y;
};

/// The hierarchy over a lattice: squares of 2·h quads a side are two triangles whose common edge is
/// their diagonal; a vertex in the middle of a longest edge splits the triangles on its both sides.
class Hierarchy {
  public:
    Hierarchy(const TerrainLattice& lattice, std::span<const float> heights,
              const ScreenScale& scale, std::vector<float>& errors)
        : lattice_(lattice),
          heights_(heights),
          scale_(scale),
          errors_(errors),
          last_x_(lattice.nx - 1),
          last_y_(lattice.ny - 1) {
        errors_.assign(heights.size(), 0.0F);
    }

    /// Finds each vertex's error up to squares of `square` quads. What a vertex needs is found
    /// before it: an error is never less than those of the vertices in its smaller triangles.
    void find_errors(int square) {
        keep_around_missing();
        for (int h = 1; 2 * h <= square; h *= 2) {
            for (int y = 0; y <= last_y_; y += h) {
                const bool odd = y / h % 2 != 0;
                for (int x = odd ? 0 : h; x <= last_x_; x += 2 * h) middle_of_side({x, y}, h, odd);
            }
            for (int y = h; y <= last_y_; y += 2 * h)
                for (int x = h; x <= last_x_; x += 2 * h) middle_of_square({x, y}, h);
        }
    }

    void add_square(Vertex corner, int square, TerrainMesh& mesh) const {
        const Vertex opposite{corner.x + square, corner.y + square};
        const Vertex east{corner.x + square, corner.y};
        const Vertex north{corner.x, corner.y + square};
        if (rises_east(corner, square)) {
            add(opposite, corner, east, mesh);
            add(corner, opposite, north, mesh);
        } else {
            add(east, north, corner, mesh);
            add(north, east, opposite, mesh);
        }
    }

  private:
    [[nodiscard]] std::uint32_t index(Vertex v) const {
        return static_cast<std::uint32_t>(v.y) * static_cast<std::uint32_t>(lattice_.nx) +
               static_cast<std::uint32_t>(v.x);
    }
    [[nodiscard]] float error(Vertex v) const { return errors_[index(v)]; }
    [[nodiscard]] bool inside(Vertex v) const {
        return v.x >= 0 && v.y >= 0 && v.x <= last_x_ && v.y <= last_y_;
    }

    /// Whether a square's diagonal goes from its south-western to its north-eastern corner.
    static bool rises_east(Vertex corner, int square) {
        return (corner.x / square + corner.y / square) % 2 == 0;
    }

    /// All vertices of a quad that is left out are kept, so that those around it stay by
    /// themselves.
    void keep_around_missing() {
        const Mask& drawn = lattice_.drawn;
        for (int y = 0; y < drawn.ny(); ++y) {
            for (int x = 0; x < drawn.nx(); ++x) {
                if (drawn(x, y) != 0) continue;
                for (const Vertex v : {Vertex{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
                    errors_[index(v)] = always;
            }
        }
    }

    [[nodiscard]] float own_error(Vertex v, Vertex a, Vertex b) const {
        const float off = heights_[index(v)] - 0.5F * (heights_[index(a)] + heights_[index(b)]);
        const MeshPosition at = lattice_.positions[index(v)];
        const float depth =
            scale_.depth + scale_.depth_east * at.east + scale_.depth_north * at.north;
        return scale_.pixels * std::abs(off) / std::max(depth, 0.05F);
    }

    /// The middle of a side of squares of 2·h, which runs north if `north`.
    void middle_of_side(Vertex v, int h, bool north) {
        float& largest = errors_[index(v)];
        const Vertex a{north ? v.x : v.x - h, north ? v.y - h : v.y};
        const Vertex b{north ? v.x : v.x + h, north ? v.y + h : v.y};
        // A square that the lattice's end cuts is split, and with it the one on the other side.
        const bool cut_x = v.x + h > last_x_ && v.x < last_x_;
        const bool cut_y = v.y + h > last_y_ && v.y < last_y_;
        if (cut_x || cut_y || !inside(b)) {
            largest = always;
            return;
        }
        largest = std::max(largest, own_error(v, a, b));
        const int half = h / 2;
        if (half == 0) return;
        for (const Vertex child : {Vertex{v.x - half, v.y - half},
                                   {v.x + half, v.y - half},
                                   {v.x - half, v.y + half},
                                   {v.x + half, v.y + half}})
            if (inside(child)) largest = std::max(largest, error(child));
    }

    void middle_of_square(Vertex v, int h) {
        float& largest = errors_[index(v)];
        if (v.x + h > last_x_ || v.y + h > last_y_) {
            largest = always;
            return;
        }
        const bool rises = rises_east({v.x - h, v.y - h}, 2 * h);
        const Vertex a{v.x - h, rises ? v.y - h : v.y + h};
        const Vertex b{v.x + h, rises ? v.y + h : v.y - h};
        largest = std::max({largest, own_error(v, a, b), error({v.x - h, v.y}),
                            error({v.x + h, v.y}), error({v.x, v.y - h}), error({v.x, v.y + h})});
    }

    /// Adds what lies within a triangle whose longest edge goes from a to b.
    void add(Vertex a, Vertex b, Vertex apex, TerrainMesh& mesh) const {
        const Vertex corner{std::min({a.x, b.x, apex.x}), std::min({a.y, b.y, apex.y})};
        if (corner.x >= last_x_ || corner.y >= last_y_) return;
        if ((a.x + b.x) % 2 == 0 && (a.y + b.y) % 2 == 0) {
            const Vertex middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
            if (!inside(middle) || error(middle) > largest_error) {
                add(apex, a, middle, mesh);
                add(b, apex, middle, mesh);
                return;
            }
        } else if (!lattice_.drawn.empty() && lattice_.drawn(corner.x, corner.y) == 0) {
            return;
        }
        for (const Vertex v : {a, b, apex}) mesh.triangles.push_back(index(v));
        add_side(a, b, mesh);
        add_side(b, apex, mesh);
        add_side(apex, a, mesh);
    }

    void add_side(Vertex a, Vertex b, TerrainMesh& mesh) const {
        const auto face = [&](MeshPosition normal) {
            mesh.sides.push_back({index(a), index(b), normal, normal});
        };
        if (a.x == 0 && b.x == 0) face({-1.0F, 0.0F});
        if (a.x == last_x_ && b.x == last_x_) face({1.0F, 0.0F});
        if (a.y == 0 && b.y == 0) face({0.0F, -1.0F});
        if (a.y == last_y_ && b.y == last_y_) face({0.0F, 1.0F});
    }

    const TerrainLattice& lattice_;
    std::span<const float> heights_;
    ScreenScale scale_;
    std::vector<float>& errors_;
    int last_x_;
    int last_y_;
};

}  // namespace

TerrainLattice terrain_lattice(int nx, int ny, const Mask& nodata, int stride) {
    const Axis east = make_axis(nx, stride);
    const Axis north = make_axis(ny, stride);
    TerrainLattice lattice;
    lattice.nx = static_cast<int>(east.cells.size());
    lattice.ny = static_cast<int>(north.cells.size());
    lattice.positions.reserve(east.cells.size() * north.cells.size());
    lattice.cells.reserve(east.cells.size() * north.cells.size());
    for (std::size_t j = 0; j < north.positions.size(); ++j) {
        for (std::size_t i = 0; i < east.positions.size(); ++i) {
            lattice.positions.push_back({east.positions[i], north.positions[j]});
            lattice.cells.push_back(static_cast<std::uint32_t>(north.cells[j]) *
                                        static_cast<std::uint32_t>(nx) +
                                    static_cast<std::uint32_t>(east.cells[i]));
        }
    }
    lattice.drawn = drawn_quads(east, north, nodata);
    return lattice;
}

int lattice_stride(double pixels_per_cell) {
    int stride = 1;
    while (stride < largest_stride && stride * pixels_per_cell < shortest_edge) stride *= 2;
    return stride;
}

int largest_square(double pixels_per_quad) {
    int square = 1;
    while (square < largest_stride && 2 * square * pixels_per_quad <= longest_edge) square *= 2;
    return square;
}

TerrainMesh TerrainMesher::mesh(const TerrainLattice& lattice, std::span<const float> heights,
                                const ScreenScale& scale, int square, ViewOrder order) {
    Hierarchy hierarchy(lattice, heights, scale, errors_);
    hierarchy.find_errors(square);
    const int columns = (lattice.nx - 2) / square + 1;
    const int rows = (lattice.ny - 2) / square + 1;
    TerrainMesh mesh;
    for (int n = 0; n < rows; ++n) {
        const int j = order.from_south ? n : rows - 1 - n;
        for (int m = 0; m < columns; ++m) {
            const int i = order.from_west ? m : columns - 1 - m;
            hierarchy.add_square({i * square, j * square}, square, mesh);
        }
    }
    return mesh;
}

}  // namespace fumon
