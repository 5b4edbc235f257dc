#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mesh/height_mesh.h"

namespace fumon {

/// A surface with its colours as a binary glTF 2.0 file (Khronos Group 2021): one mesh of 32-bit
/// positions, normals and texture places, one material that shows the texture as it is (its light
/// is drawn into it: KHR_materials_unlit), and the texture itself, a PNG file. y points up, x east
/// and z south, around the middle of the surface and its lowest point. The same input gives the
/// same bytes.
std::string glb_file(const HeightMesh& mesh, std::span<const std::uint8_t> texture_png);

}  // namespace fumon
