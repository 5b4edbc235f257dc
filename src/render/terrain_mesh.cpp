#include "render/terrain_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

constexpr double longest_edge = 6.5;    // pixels: longer ones show as facets at silhouettes
constexpr double largest_error = 0.6;   // pixels between mesh and bed, beyond which …
constexpr double allowed_share = 0.01;  // … no larger share of the cells may lie
constexpr double shortest_edge = 2.2;   // pixels: nothing is gained by finer triangles
constexpr int largest_stride = 64;
constexpr int rim_reach = 10;  // cells that a rim's smoothed direction looks around
constexpr int strip = 24;      // columns drawn together: their vertices stay in the vertex cache

/// The vertices along one axis: where they stand, 0 … 1, and which cell gives the height.
struct Axis {
    std::vector<float> places;
    std::vector<int> cells;
};

Axis make_axis(int count, int stride) {
    Axis axis;
    axis.places.push_back(0.0F);
    axis.cells.push_back(0);
    for (int cell = stride / 2; cell < count; cell += stride) {
        axis.places.push_back((static_cast<float>(cell) + 0.5F) / static_cast<float>(count));
        axis.cells.push_back(cell);
    }
    axis.places.push_back(1.0F);
    axis.cells.push_back(count - 1);
    return axis;
}

/// Which quads of the vertex lattice are drawn.
class QuadSet {
  public:
    QuadSet(const Axis& east, const Axis& north, const Mask& nodata)
        : drawn_(static_cast<int>(east.cells.size()) - 1, static_cast<int>(north.cells.size()) - 1,
                 1) {
        if (nodata.empty()) return;
        for (int j = 0; j < drawn_.ny(); ++j) {
            for (int i = 0; i < drawn_.nx(); ++i) {
                const auto a = static_cast<std::size_t>(i);
                const auto b = static_cast<std::size_t>(j);
                const int outside = nodata(east.cells[a], north.cells[b]) +
                                    nodata(east.cells[a + 1], north.cells[b]) +
                                    nodata(east.cells[a], north.cells[b + 1]) +
                                    nodata(east.cells[a + 1], north.cells[b + 1]);
                drawn_(i, j) = outside == 0 ? 1 : 0;
            }
        }
    }
    [[nodiscard]] bool operator()(int i, int j) const {
        return i >= 0 && j >= 0 && i < drawn_.nx() && j < drawn_.ny() && drawn_(i, j) != 0;
    }
    [[nodiscard]] int nx() const { return drawn_.nx(); }
    [[nodiscard]] int ny() const { return drawn_.ny(); }

  private:
    Mask drawn_;
};

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

/// Which way the domain ends at a cell: away from the middle of the cells around that have data, so
/// that the steps of a rim of square cells are shaded as one face. Keeps `flat` at straight
/// borders.
std::array<float, 2> rim_direction(const Mask& nodata, int x, int y, std::array<float, 2> flat) {
    float east = 0.0F;
    float north = 0.0F;
    for (int v = y - rim_reach; v <= y + rim_reach; ++v) {
        for (int u = x - rim_reach; u <= x + rim_reach; ++u) {
            // Beyond the border the nearest cell is repeated.
            const int cell_x = std::clamp(u, 0, nodata.nx() - 1);
            const int cell_y = std::clamp(v, 0, nodata.ny() - 1);
            if (nodata(cell_x, cell_y) == 0) continue;
            east += static_cast<float>(u - x);
            north += static_cast<float>(v - y);
        }
    }
    const float length = std::sqrt(east * east + north * north);
    if (length < 1.0F) return flat;
    return {east / length, north / length};
}

void add_sides(TerrainMesh& mesh, const QuadSet& quads, const Mask& nodata) {
    const auto width = static_cast<std::uint32_t>(quads.nx() + 1);
    for (int j = 0; j < quads.ny(); ++j) {
        for (int i = 0; i < quads.nx(); ++i) {
            if (!quads(i, j)) continue;
            for (const QuadSide& side : quad_sides) {
                if (quads(i + side.step_x, j + side.step_y)) continue;
                const auto vertex = [&](const std::array<int, 2>& end) {
                    return static_cast<std::uint32_t>(j + end[1]) * width +
                           static_cast<std::uint32_t>(i + end[0]);
                };
                const auto corner = static_cast<std::uint32_t>(mesh.side_corners.size());
                const std::array<float, 2> flat{static_cast<float>(side.step_x),
                                                static_cast<float>(side.step_y)};
                const bool border = i + side.step_x < 0 || i + side.step_x >= quads.nx() ||
                                    j + side.step_y < 0 || j + side.step_y >= quads.ny();
                const auto add = [&](const std::array<int, 2>& end, float lower) {
                    const std::uint32_t at = vertex(end);
                    const auto cell = static_cast<int>(mesh.samples[at]);
                    const auto normal = border ? flat
                                               : rim_direction(nodata, cell % nodata.nx(),
                                                               cell / nodata.nx(), flat);
                    mesh.side_corners.push_back({at, lower, normal[0], normal[1]});
                };
                add(side.from, 1.0F);
                add(side.to, 1.0F);
                add(side.to, 0.0F);
                add(side.from, 0.0F);
                for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U})
                    mesh.side_triangles.push_back(corner + k);
            }
        }
    }
}

void add_triangles(TerrainMesh& mesh, const QuadSet& quads, ViewOrder order) {
    const auto width = static_cast<std::uint32_t>(quads.nx() + 1);
    for (int first = 0; first < quads.nx(); first += strip) {
        const int last = std::min(first + strip, quads.nx());
        for (int n = 0; n < quads.ny(); ++n) {
            const int j = order.from_south ? n : quads.ny() - 1 - n;
            for (int m = first; m < last; ++m) {
                const int i = order.from_west ? m : quads.nx() - 1 - m;
                if (!quads(i, j)) continue;
                const std::uint32_t corner =
                    static_cast<std::uint32_t>(j) * width + static_cast<std::uint32_t>(i);
                for (const std::uint32_t k : {0U, 1U, width + 1U, 0U, width + 1U, width})
                    mesh.triangles.push_back(corner + k);
            }
        }
    }
}

/// The share of left-out cells on the middle of a mesh edge that lie too far from it.
double share_beyond(const DisplayBed& bed, int stride, float tolerance) {
    const int half = stride / 2;
    std::size_t beyond = 0;
    std::size_t count = 0;
    for (int y = half; y < bed.z.ny(); y += stride) {
        const float* row = bed.z.row(y).data();
        for (int x = 0; x + stride < bed.z.nx(); x += stride) {
            const float error = row[x + half] - 0.5F * (row[x] + row[x + stride]);
            beyond += std::abs(error) > tolerance ? 1U : 0U;
            ++count;
        }
    }
    for (int y = 0; y + stride < bed.z.ny(); y += stride) {
        const float* south = bed.z.row(y).data();
        const float* middle = bed.z.row(y + half).data();
        const float* north = bed.z.row(y + stride).data();
        for (int x = half; x < bed.z.nx(); x += stride) {
            const float error = middle[x] - 0.5F * (south[x] + north[x]);
            beyond += std::abs(error) > tolerance ? 1U : 0U;
            ++count;
        }
    }
    return count == 0 ? 0.0 : static_cast<double>(beyond) / static_cast<double>(count);
}

}  // namespace

TerrainMesh terrain_mesh(int nx, int ny, const Mask& nodata, int stride, ViewOrder order) {
    const Axis east = make_axis(nx, stride);
    const Axis north = make_axis(ny, stride);
    TerrainMesh mesh;
    for (std::size_t j = 0; j < north.places.size(); ++j) {
        for (std::size_t i = 0; i < east.places.size(); ++i) {
            mesh.places.push_back({east.places[i], north.places[j]});
            mesh.samples.push_back(static_cast<std::uint32_t>(north.cells[j]) *
                                       static_cast<std::uint32_t>(nx) +
                                   static_cast<std::uint32_t>(east.cells[i]));
        }
    }
    const QuadSet quads(east, north, nodata);
    add_triangles(mesh, quads, order);
    add_sides(mesh, quads, nodata);
    return mesh;
}

int mesh_stride(const DisplayBed& bed, double pixels_per_cell, double pixels_per_z) {
    int stride = 1;
    const auto tolerance = static_cast<float>(largest_error / pixels_per_z);
    while (2 * stride <= largest_stride && 2 * stride * pixels_per_cell <= longest_edge) {
        const bool fine_enough = stride * pixels_per_cell >= shortest_edge;
        if (fine_enough && share_beyond(bed, 2 * stride, tolerance) > allowed_share) break;
        stride *= 2;
    }
    return stride;
}

}  // namespace fumon
