#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace fumon {

/// The resolved scene as nested JSON: every key with its value, defaults included.
nlohmann::ordered_json scene_json(const Scene& scene);

}  // namespace fumon
