#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

struct MeshPoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

/// Triangles over numbered points, counter-clockwise seen from outside.
struct Mesh {
    std::vector<MeshPoint> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A bed as a surface of points at the centres of its cells, x east, y north, z up, in metres (or
/// sites and model heights) from the south-west corner, heights times `exaggeration`. Four
/// neighbours with data make two triangles; where two such squares meet at one corner alone, one of
/// them is left out.
struct HeightMesh {
    Mesh top;
    std::vector<std::array<double, 2>> places;  ///< of each point on the bed, 0 … 1 east and north
    int cells_per_point = 1;                    ///< along each side
};

/// Of at most so many triangles: else each point is the mean of k × k cells, as few as do; one with
/// data in less than half of them has none. Throws InputError where no square has data.
HeightMesh height_mesh(const Snapshot& snapshot, double exaggeration, std::size_t most_triangles);

/// A surface whose edges are closed by upright walls down to z = `floor`, which lies below it, and
/// a floor: each edge belongs to two triangles that run along it in opposite directions.
Mesh closed_solid(const Mesh& top, double floor);

}  // namespace fumon
