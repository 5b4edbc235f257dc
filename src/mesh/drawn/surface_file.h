#pragma once

#include <string>
#include <string_view>

#include "base/image.h"
#include "base/snapshot.h"
#include "mesh/height_mesh.h"
#include "run/terminal/work_options.h"
#include "scene/scene.h"

namespace fumon {

/// A bed from above, as far as it reaches and with nothing over it, its longer side 2048 pixels.
/// `scene`: how it looks; `note` gets what the user should hear of its drape and layers.
Image picture_from_above(Scene scene, const Snapshot& snapshot, const WorkOptions& work,
                         std::string& note);

/// An STL of a surface as it is printed: its longer side `size` millimetres, standing on z = 0,
/// `base` millimetres below its lowest point.
std::string printed_file(const HeightMesh& surface, double size, double base);

/// A surface with the colours of a picture from above: of the kind "glb", "ply" or "obj".
std::string coloured_file(std::string_view kind, const HeightMesh& mesh, const Image& picture);

}  // namespace fumon
