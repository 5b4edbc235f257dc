#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geo_reference.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/mesh/mesh.h"

namespace fumon {

/// Which variables and dimensions of a file make a mesh, by their NetCDF numbers.
struct MeshLayout {
    std::string name;  ///< of the variable of its topology, "mesh2d"; empty of ANUGA's
    bool anuga = false;
    int node_x = -1;
    int node_y = -1;
    int connectivity = -1;  ///< the nodes of each face
    int nodes = -1;         ///< a dimension, as are those of faces and of a face's corners
    int faces = -1;
    int corners = -1;
};

/// The mesh of two dimensions that a file holds: by the UGRID conventions 1.0 (a variable whose
/// cf_role is mesh_topology), or of ANUGA's .sww (volumes over points). Nothing of a file without
/// one. Throws InputError, one line, for a mesh of lines alone and for variables that it names and
/// has not. The caller holds the NetcdfLock.
std::optional<MeshLayout> find_mesh(const NetcdfInput& input);

/// A mesh and where its south-west lies.
struct PlacedMesh {
    FaceMesh mesh;
    double west = 0.0;  ///< metres, or degrees
    double south = 0.0;
    bool degrees = false;
    double metres_per_x = 1.0;  ///< on the ground, of what the coordinates are in
    double metres_per_y = 1.0;
    std::string note{};
};

/// Reads it. Faces count their nodes from 0 or 1 (start_index), and fill the places of corners that
/// they have not; nodes in degrees become metres at the middle latitude. Throws InputError for
/// nodes that do not exist, coordinates that are missing, and for a mesh without a face.
PlacedMesh read_mesh(const NetcdfInput& input, const MeshLayout& layout);

}  // namespace fumon
