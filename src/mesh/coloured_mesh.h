#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "mesh/height_mesh.h"

namespace fumon {

/// Red, green and blue of a point, sRGB.
using PointColour = std::array<std::uint8_t, 3>;

/// A mesh with the colour of each of its points as a binary little-endian PLY file: x east, y
/// north, z up, as float, and red, green and blue as uchar. The same mesh gives the same bytes.
std::string ply_file(const Mesh& mesh, std::span<const PointColour> colours);

/// The same as a Wavefront OBJ file, whose lines "v x y z r g b" end in colours from 0 to 1, as
/// MeshLab, Blender and others read them. z is up.
std::string obj_file(const Mesh& mesh, std::span<const PointColour> colours);

}  // namespace fumon
