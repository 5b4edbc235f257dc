#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// A terrain file alone as a scene: the static model with the standard look. `heights` is
/// "low:high", the metres of black and white of a PNG terrain, or empty. Throws InputError.
Scene terrain_scene(const std::string& file, const std::string& heights,
                    const std::vector<std::string>& settings);

}  // namespace fumon
