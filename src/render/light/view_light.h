#pragma once

#include "render/light/light.h"
#include "scene/scene.h"

namespace fumon {

/// The light of a view, whose ground is chosen: of its sky.
Light light_of_view(const View& view);

}  // namespace fumon
