#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/view/display_bed.h"

namespace fumon {

/// A point on the bed in shares of its extents, 0 … 1 east and north.
struct MeshPosition {
    float east;
    float north;
};

/// The points where a mesh of a display bed may have vertices: the centres of every stride-th cell,
/// and the border. Only the vertices' heights change from frame to frame.
struct TerrainLattice {
    int nx = 0;  ///< vertices eastward
    int ny = 0;
    std::vector<MeshPosition> positions;
    std::vector<std::uint32_t> cells;  ///< of each vertex: the cell that gives its height
    Mask drawn;                        ///< which quads between vertices; empty: all
};

/// The vertical face under an edge of the mesh at which the bed ends, and which way it looks at the
/// two ends.
struct SideFace {
    std::uint32_t from;
    std::uint32_t to;
    MeshPosition normal_from;
    MeshPosition normal_to;
};

/// What is drawn of a lattice.
struct TerrainMesh {
    std::vector<std::uint32_t> triangles;  ///< three vertices each
    std::vector<SideFace> sides;
};

/// Which way a camera looks over the bed: rows and columns are drawn from near to far.
struct ViewOrder {
    bool from_south = true;
    bool from_west = true;
};

/// How large lengths of a block are on the screen: pixels / (depth at the point), the depth being 1
/// at the block's middle and linear in the place.
struct ScreenScale {
    float pixels = 1.0F;  ///< that one z spans at the block's middle
    float depth = 1.0F;   ///< at point (0, 0)
    float depth_east = 0.0F;
    float depth_north = 0.0F;
};

/// The lattice of a bed of nx × ny cells. Quads at cells without data are left out.
TerrainLattice terrain_lattice(int nx, int ny, const Mask& nodata, int stride);

/// The stride of the lattice (1, 2, 4, …): as fine as triangles are of use where one cell spans
/// `pixels_per_cell`.
int lattice_stride(double pixels_per_cell);

/// The largest side of a square of quads that may become two triangles (1, 2, 4, …), where a quad
/// spans `pixels_per_quad`.
int largest_square(double pixels_per_quad);

/// Meshes a lattice with as few triangles as its heights (block lengths) allow: a vertex is left
/// out where the middle of the edge in its place lies within `largest_error` pixels of it.
/// A hierarchy of right-angled triangles without cracks (Evans, Kirkpatrick & Townsend 2001). The
/// outer border gets its vertical faces.
class TerrainMesher {
  public:
    TerrainMesh mesh(const TerrainLattice& lattice, std::span<const float> heights,
                     const ScreenScale& scale, int square, ViewOrder order);

  private:
    std::vector<float> errors_;  ///< of each vertex and of all that need it, pixels
};

}  // namespace fumon
