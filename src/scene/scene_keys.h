#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// Every key of the scene, bound to it: the common ones, then those of its model.
KeyTable scene_keys(Scene& scene);

/// A scene of a model with every key at its default.
Scene default_scene(const std::string& model);

/// The settings of the look ("look.field=\"tau\"") that let the ground be coloured by a quantity:
/// look.colour_by and a palette that suits it, by a word of look.colour_by or the name of a field,
/// then with look.field. None of an empty name.
std::vector<std::string> colour_settings(const std::string& colour);

}  // namespace fumon
