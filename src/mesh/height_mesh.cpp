#include "mesh/height_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Heights on a grid of points; NaN where there are none.
struct PointGrid {
    Grid heights;
    int cells = 1;  ///< of the bed, along each side of a point
};

PointGrid coarsened(const Snapshot& snapshot, int cells) {
    const Grid& bed = snapshot.bed;
    PointGrid points{Grid((bed.nx() + cells - 1) / cells, (bed.ny() + cells - 1) / cells), cells};
    for (int py = 0; py < points.heights.ny(); ++py) {
        for (int px = 0; px < points.heights.nx(); ++px) {
            double sum = 0.0;
            int known = 0;
            int all = 0;
            for (int y = py * cells; y < std::min((py + 1) * cells, bed.ny()); ++y) {
                for (int x = px * cells; x < std::min((px + 1) * cells, bed.nx()); ++x) {
                    ++all;
                    if (!snapshot.nodata.empty() && snapshot.nodata(x, y) != 0) continue;
                    sum += bed(x, y);
                    ++known;
                }
            }
            points.heights(px, py) = 2 * known >= all && known > 0 ? sum / known : std::nan("");
        }
    }
    return points;
}

/// 1 where the square north-east of a point has data at its four corners.
Mask squares_of(const Grid& heights) {
    Mask squares(std::max(heights.nx() - 1, 0), std::max(heights.ny() - 1, 0));
    for (int y = 0; y < squares.ny(); ++y) {
        for (int x = 0; x < squares.nx(); ++x) {
            const double sum =
                heights(x, y) + heights(x + 1, y) + heights(x, y + 1) + heights(x + 1, y + 1);
            squares(x, y) = std::isnan(sum) ? 0 : 1;
        }
    }
    return squares;
}

/// Leaves squares out until none meets another at one corner alone.
void part_corners(Mask& squares) {
    for (bool changed = true; std::exchange(changed, false);) {
        for (int y = 0; y + 1 < squares.ny(); ++y) {
            for (int x = 0; x + 1 < squares.nx(); ++x) {
                const bool here = squares(x, y) != 0;
                const bool east = squares(x + 1, y) != 0;
                const bool north = squares(x, y + 1) != 0;
                const bool across = squares(x + 1, y + 1) != 0;
                if (here != across || east != north || here == east) continue;
                (here ? squares(x + 1, y + 1) : squares(x, y + 1)) = 0;
                changed = true;
            }
        }
    }
}

}  // namespace

HeightMesh height_mesh(const Snapshot& snapshot, double exaggeration, std::size_t most_triangles) {
    const double cells = static_cast<double>(snapshot.bed.size());
    const double at_least = std::sqrt(2.0 * cells / static_cast<double>(most_triangles));
    const PointGrid grid = coarsened(snapshot, std::max(1, static_cast<int>(std::ceil(at_least))));
    Mask squares = squares_of(grid.heights);
    part_corners(squares);

    HeightMesh mesh;
    mesh.cells_per_point = grid.cells;
    Field<std::uint32_t> numbers(grid.heights.nx(), grid.heights.ny(), none);
    const WorldScale& scale = snapshot.scale;
    const auto point = [&](int x, int y) {
        std::uint32_t& number = numbers(x, y);
        if (number != none) return number;
        number = static_cast<std::uint32_t>(mesh.top.points.size());
        // The middle of the cells that it stands for, of which the last may be fewer.
        const auto middle = [&](int i, int count) {
            return 0.5 * (i * grid.cells + std::min((i + 1) * grid.cells, count));
        };
        const double east = middle(x, snapshot.bed.nx());
        const double north = middle(y, snapshot.bed.ny());
        mesh.top.points.push_back({east * scale.dx, north * scale.dy,
                                   grid.heights(x, y) * scale.height_unit * exaggeration});
        mesh.places.push_back({east / snapshot.bed.nx(), north / snapshot.bed.ny()});
        return number;
    };
    for (int y = 0; y < squares.ny(); ++y) {
        for (int x = 0; x < squares.nx(); ++x) {
            if (squares(x, y) == 0) continue;
            const std::uint32_t south_west = point(x, y);
            const std::uint32_t south_east = point(x + 1, y);
            const std::uint32_t north_west = point(x, y + 1);
            const std::uint32_t north_east = point(x + 1, y + 1);
            mesh.top.triangles.push_back({south_west, south_east, north_east});
            mesh.top.triangles.push_back({south_west, north_east, north_west});
        }
    }
    if (mesh.top.triangles.empty())
        throw InputError("no four neighbouring cells have data: there is no surface to write");
    return mesh;
}

Mesh closed_solid(const Mesh& top, double floor) {
    Mesh solid = top;
    const auto count = static_cast<std::uint32_t>(top.points.size());
    for (const MeshPoint& point : top.points) solid.points.push_back({point.x, point.y, floor});
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;  // run along by one triangle
    for (const auto& triangle : top.triangles) {
        solid.triangles.push_back({triangle[0] + count, triangle[2] + count, triangle[1] + count});
        for (std::size_t k = 0; k < 3; ++k) edges[{triangle[k], triangle[(k + 1) % 3]}] = true;
    }
    for (const auto& [edge, once] : edges) {
        const auto [from, to] = edge;
        if (edges.contains({to, from})) continue;
        solid.triangles.push_back({to, from, from + count});
        solid.triangles.push_back({to, from + count, to + count});
    }
    return solid;
}

}  // namespace fumon
