#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// The keys of how a run is seen: camera, sun, air, look and image, bound to a view.
void list_view_keys(View& view, KeyTable& table);

/// Every key of the scene, bound to it: the common ones, then those of its model.
KeyTable scene_keys(Scene& scene);

/// A scene of a model with every key at its default.
Scene default_scene(const std::string& model);

}  // namespace fumon
