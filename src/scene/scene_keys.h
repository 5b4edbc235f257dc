#pragma once

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// Every key of the scene, bound to it: the common ones, then those of its model.
KeyTable scene_keys(Scene& scene);

}  // namespace fumon
