#pragma once

#include <string>

#include "scene/scene.h"

namespace fumon {

/// A paragraph for a paper's methods, ready to be edited: program and version, model, what it takes
/// from which work, grid, steps, the parameters that differ from the defaults with their units, and
/// the scene's SHA-256 (hexadecimal).
std::string methods_text(const Scene& scene, const std::string& scene_hash);

}  // namespace fumon
