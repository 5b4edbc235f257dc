#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// Every file that a scene names: its terrain, the scenes and tables of its figure, and what those
/// scenes name. Whether they are there is not looked at.
std::vector<std::filesystem::path> scene_files(const Scene& scene);

}  // namespace fumon
