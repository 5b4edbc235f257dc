#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// Every key of the scene, bound to it: the common ones, then those of its model.
KeyTable scene_keys(Scene& scene);

/// A scene of a model with every key at its default.
Scene default_scene(const std::string& model);

}  // namespace fumon
