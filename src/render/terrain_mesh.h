#pragma once

#include <cstdint>
#include <vector>

#include "render/view/display_bed.h"

namespace fumon {

/// A place on the bed in shares of its extents, 0 … 1 east and north.
struct MeshPlace {
    float east;
    float north;
};

/// A corner of a vertical side face: which mesh vertex it belongs to, whether it is the lower end,
/// and which way the face looks.
struct SideCorner {
    std::uint32_t vertex;
    float lower;  ///< 1 at the block's underside, 0 at the surface
    float normal_x;
    float normal_y;
};

/// The triangles of a display bed. Vertices stand at cell centres, every stride-th, and on the
/// border; only their heights change from frame to frame.
struct TerrainMesh {
    std::vector<MeshPlace> places;
    std::vector<std::uint32_t> samples;    ///< of each vertex: the cell that gives its height
    std::vector<std::uint32_t> triangles;  ///< three vertices each, near strips first
    std::vector<SideCorner> side_corners;  ///< four to a face
    std::vector<std::uint32_t> side_triangles;
};

/// Which way a camera looks over the bed: rows and columns are drawn from near to far.
struct ViewOrder {
    bool from_south = true;
    bool from_west = true;
};

/// Meshes a bed of nx × ny cells. Cells without data are left out, and the rim they leave gets
/// vertical faces as the outer border does, so that the block looks solid.
TerrainMesh terrain_mesh(int nx, int ny, const Mask& nodata, int stride, ViewOrder order);

/// The coarsest stride (1, 2, 4, …) allowed for a bed: a mesh edge is at most `longest_edge` pixels
/// long where one cell spans `pixels_per_cell`, and no more than one vertex in a hundred left out
/// lies further than `largest_error` pixels from the mesh (`pixels_per_z` pixels to one z).
int mesh_stride(const DisplayBed& bed, double pixels_per_cell, double pixels_per_z);

}  // namespace fumon
