#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "foreign/field_choice.h"
#include "foreign/mesh_maps.h"

namespace fumon {

/// How much water a record has on a mesh's cells, and by how much that differs from the mesh
/// itself, in a line; empty where no map of water, or its level and bed in different places, tells.
/// `values_of`: that record of a map, metres, NaN where it has none.
std::string volume_note(const LaidMesh& mesh, const std::vector<ChosenMap>& chosen,
                        std::size_t record,
                        const std::function<std::vector<double>(const ChosenMap&)>& values_of);

}  // namespace fumon
