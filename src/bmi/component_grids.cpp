// The grids of a component: its cells' centres, and the scalars of its scene.

#include <fmt/format.h>

#include "base/error.h"
#include "bmi/component.h"

namespace fumon {

bool BmiComponent::is_raster(int grid) {
    static_cast<void>(model());
    if (grid == 0) return true;
    if (grid == 1) return false;
    throw InputError(
        fmt::format("there is no grid {}; grid 0 holds the cells, grid 1 is the scalar", grid));
}

void BmiComponent::need_raster(int grid, const char* what) {
    if (!is_raster(grid)) throw InputError(fmt::format("grid 1 is a scalar and has no {}", what));
}

int BmiComponent::GetGridRank(int grid) {
    return is_raster(grid) ? 2 : 0;
}

int BmiComponent::GetGridSize(int grid) {
    return is_raster(grid) ? static_cast<int>(model().now().bed.size()) : 1;
}

std::string BmiComponent::GetGridType(int grid) {
    return is_raster(grid) ? "uniform_rectilinear" : "scalar";
}

void BmiComponent::GetGridShape(int grid, int* shape) {
    need_raster(grid, "shape");
    shape[0] = model().now().bed.ny();
    shape[1] = model().now().bed.nx();
}

void BmiComponent::GetGridSpacing(int grid, double* spacing) {
    need_raster(grid, "spacing");
    spacing[0] = model().now().scale.dy;
    spacing[1] = model().now().scale.dx;
}

void BmiComponent::GetGridOrigin(int grid, double* origin) {
    need_raster(grid, "origin");
    origin[0] = 0.5 * model().now().scale.dy;
    origin[1] = 0.5 * model().now().scale.dx;
}

void BmiComponent::GetGridX(int grid, double* x) {
    need_raster(grid, "x");
    for (int i = 0; i < model().now().bed.nx(); ++i) x[i] = (i + 0.5) * model().now().scale.dx;
}

void BmiComponent::GetGridY(int grid, double* y) {
    need_raster(grid, "y");
    for (int i = 0; i < model().now().bed.ny(); ++i) y[i] = (i + 0.5) * model().now().scale.dy;
}

void BmiComponent::GetGridZ(int grid, double* /*z*/) {
    need_raster(grid, "z");
    throw InputError("grid 0 has rank 2 and no z; the bed is land_surface__elevation");
}

int BmiComponent::GetGridNodeCount(int grid) {
    return GetGridSize(grid);
}

int BmiComponent::GetGridEdgeCount(int grid) {
    if (!is_raster(grid)) return 0;
    const int nx = model().now().bed.nx();
    const int ny = model().now().bed.ny();
    return ny * (nx - 1) + nx * (ny - 1);
}

int BmiComponent::GetGridFaceCount(int grid) {
    if (!is_raster(grid)) return 0;
    return (model().now().bed.nx() - 1) * (model().now().bed.ny() - 1);
}

void BmiComponent::GetGridEdgeNodes(int grid, int* edge_nodes) {
    need_raster(grid, "edges");
    const int nx = model().now().bed.nx();
    const int ny = model().now().bed.ny();
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x + 1 < nx; ++x) {
            *edge_nodes++ = y * nx + x;
            *edge_nodes++ = y * nx + x + 1;
        }
    }
    for (int y = 0; y + 1 < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            *edge_nodes++ = y * nx + x;
            *edge_nodes++ = (y + 1) * nx + x;
        }
    }
}

void BmiComponent::GetGridFaceEdges(int grid, int* face_edges) {
    need_raster(grid, "faces");
    const int nx = model().now().bed.nx();
    const int ny = model().now().bed.ny();
    const int along_x = ny * (nx - 1);  // edges before those along y
    for (int y = 0; y + 1 < ny; ++y) {
        for (int x = 0; x + 1 < nx; ++x) {
            *face_edges++ = y * (nx - 1) + x;
            *face_edges++ = along_x + y * nx + x + 1;
            *face_edges++ = (y + 1) * (nx - 1) + x;
            *face_edges++ = along_x + y * nx + x;
        }
    }
}

void BmiComponent::GetGridFaceNodes(int grid, int* face_nodes) {
    need_raster(grid, "faces");
    const int nx = model().now().bed.nx();
    const int ny = model().now().bed.ny();
    for (int y = 0; y + 1 < ny; ++y) {
        for (int x = 0; x + 1 < nx; ++x) {
            *face_nodes++ = y * nx + x;
            *face_nodes++ = y * nx + x + 1;
            *face_nodes++ = (y + 1) * nx + x + 1;
            *face_nodes++ = (y + 1) * nx + x;
        }
    }
}

void BmiComponent::GetGridNodesPerFace(int grid, int* nodes_per_face) {
    need_raster(grid, "faces");
    const int faces = GetGridFaceCount(grid);
    for (int i = 0; i < faces; ++i) nodes_per_face[i] = 4;
}

}  // namespace fumon
