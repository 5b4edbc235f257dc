#pragma once

#include "scene/scene.h"

namespace fumon {

/// Whether a scene's model lives in metres, as all but sand, piles and bare terrain do: heights are
/// metres, and lengths are told in metres everywhere.
bool uses_metres(const Scene& scene);

}  // namespace fumon
