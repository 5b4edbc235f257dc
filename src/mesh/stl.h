#pragma once

#include <string>

#include "mesh/height_mesh.h"

namespace fumon {

/// A mesh as a binary STL file, its numbers as they are (printers take them for millimetres). The
/// same mesh gives the same bytes.
std::string stl_file(const Mesh& mesh);

}  // namespace fumon
